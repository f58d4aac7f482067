// SPDX-License-Identifier: Apache-2.0
// Commands and their options, as the command line's parser (CLI11) knows them. Its header takes longer to compile than
// any command does; this one stands before it.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/command_description.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace pyrasim::cli {

/// What main() runs once the command line has been read; throws pyrasim::Error.
using Action = std::function<void()>;

/// An option or argument; how the help shows it and what it must hold. Each function returns the option again.
class Option {
 public:
  explicit Option(CLI::Option* option) : option_(option) {}
  const Option& required() const;
  const Option& type_name(const std::string& name) const;
  /// The help shows the value that the variable has now, or `text`.
  const Option& show_default() const;
  const Option& show_default(const std::string& text) const;
  /// `mistake` says what is wrong with a text; it is empty for one that is allowed.
  const Option& check(const std::function<std::string(const std::string& text)>& mistake) const;

 private:
  CLI::Option* option_;
};

/// A command. Of an option given twice the last one counts; all options refer to variables that must outlive parsing.
/// None takes an empty value: a variable that the shell left empty is a mistake, not an option that is not given.
class Command {
 public:
  /// A command below this one, and what it runs.
  Command add_command(const std::string& name, const std::string& description, Action run) const;
  /// Whether the command line has the option of that name.
  bool given(const std::string& option) const;
  /// A command that only has others below it.
  Command add_group(const std::string& name, const std::string& description) const;

  Option add_text(const std::string& name, std::string& value, const std::string& description) const;
  Option add_text(const std::string& name, std::optional<std::string>& value, const std::string& description) const;
  /// May be given several times.
  Option add_texts(const std::string& name, std::vector<std::string>& values, const std::string& description) const;
  /// Arguments without an option's name, one or more.
  Option add_arguments(const std::string& name, std::vector<std::string>& values, const std::string& description) const;

  /// Without a value: given or not.
  Option add_flag(const std::string& name, bool& value, const std::string& description) const;

  /// A number from `least` to `most`; NaN is outside.
  Option add_number(const std::string& name, double& value, double least, double most,
                    const std::string& description) const;
  Option add_number(const std::string& name, std::optional<double>& value, double least, double most,
                    const std::string& description) const;
  /// A whole number from `least` to `most`.
  Option add_integer(const std::string& name, int& value, int least, int most, const std::string& description) const;
  Option add_integer(const std::string& name, std::uint64_t& value, std::uint64_t least, std::uint64_t most,
                     const std::string& description) const;

  /// One of `choices` by its name; the first is the default.
  template <class Value>
  Option add_choice(const std::string& name, Value& value, const std::vector<std::pair<std::string, Value>>& choices,
                    const std::string& description) const {
    std::vector<std::string> names;
    names.reserve(choices.size());
    for (const auto& choice : choices) names.push_back(choice.first);
    return add_named(
        name, names, [&value, choices](std::size_t index) { value = choices[index].second; }, description);
  }

 private:
  friend class CommandParser;
  Command(CLI::App* app, Action* chosen) : app_(app), chosen_(chosen) {}
  Option add_named(const std::string& name, const std::vector<std::string>& names,
                   const std::function<void(std::size_t)>& set, const std::string& description) const;

  CLI::App* app_;
  Action* chosen_;
};

/// The program's command line.
class CommandParser {
 public:
  CommandParser(const std::string& name, const std::string& description, const std::string& version,
                const std::string& footer);
  CommandParser(const CommandParser&) = delete;
  CommandParser& operator=(const CommandParser&) = delete;
  ~CommandParser();

  Command root() { return {app_.get(), &chosen_}; }

  /// What the chosen command runs; none where the help or the version was asked for and has been printed.
  /// Throws UsageError.
  std::optional<Action> parse(int argc, char** argv);

  /// All commands and options, as added so far.
  CommandDescription description() const;

 private:
  std::unique_ptr<CLI::App> app_;
  Action chosen_;
};

}  // namespace pyrasim::cli
