// SPDX-License-Identifier: Apache-2.0
#include "cli/command_parser.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <charconv>

#include "cli/nearest.h"
#include "error.h"
#include "text/printable.h"

namespace pyrasim::cli {
namespace {

/// `text` as a number from `least` to `most`, all of it; none otherwise.
template <class Number>
std::optional<Number> number_within(const std::string& text, Number least, Number most) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  return whole && number >= least && number <= most ? std::optional(number) : std::nullopt;
}

/// `Value`: Number, or std::optional of it.
template <class Number, class Value>
Option add_limited(CLI::App& app, const std::string& name, Value& value, Number least, Number most,
                   const std::string& description, std::string_view kind) {
  const auto set = [&value, least, most](const std::string& text) { value = number_within(text, least, most).value(); };
  const auto check = [=](const std::string& text) {
    if (number_within(text, least, most)) return std::string();
    return fmt::format("{}: a {} from {} to {} is allowed", excerpt(text), kind, least, most);
  };
  CLI::Option* option = app.add_option_function<std::string>(name, set, description);
  if constexpr (std::is_same_v<Value, Number>) {
    option->default_function([&value] { return fmt::format("{}", value); });
  }
  return Option(option).check(check).type_name(std::is_integral_v<Number> ? "N" : "NUMBER");
}

/// The command that the line got to.
const CLI::App& chosen(const CLI::App& app) {
  const auto commands = app.get_subcommands();
  return commands.empty() ? app : chosen(*commands.front());
}

std::string full_name(const CLI::App& command) {
  return command.get_parent() == nullptr ? command.get_name()
                                         : full_name(*command.get_parent()) + " " + command.get_name();
}

std::vector<std::string> command_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::App* each : command.get_subcommands({})) {
    names.push_back(each->get_name());
  }
  return names;
}

std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

std::string unknown(const std::string& word, const std::string& what, const std::vector<std::string>& known) {
  const std::optional<std::string> meant = nearest(word, known);
  return fmt::format("{}: unknown {}{}", excerpt(word), what, meant ? fmt::format("; did you mean {}?", *meant) : ";");
}

/// Options that were called otherwise: the name then, and now.
constexpr std::array<std::pair<std::string_view, std::string_view>, 1> former_options{{{"--leaf", "--edge"}}};

std::string unknown_option(const std::string& name, const std::vector<std::string>& known) {
  for (const auto& [then, now] : former_options) {
    if (name == then && std::find(known.begin(), known.end(), now) != known.end())
      return fmt::format("{}: has another name now, {};", then, now);
  }
  return unknown(name, "option", known);
}

/// What nobody expected, by its likeliest cause: an option, or the name of a command.
std::string unexpected(const CLI::App& app, const CLI::App& command) {
  const std::vector<std::string> words = app.remaining(true);
  const auto option = std::find_if(words.begin(), words.end(), [](const auto& word) { return word.starts_with('-'); });
  if (option != words.end()) {
    return unknown_option(option->substr(0, option->find('=')), option_names(command));
  }
  const std::vector<std::string> commands = command_names(command);
  if (!commands.empty()) return unknown(words.front(), "command", commands);
  return fmt::format("{}: not expected;", excerpt(words.front()));
}

/// In front of all other checks, which transform() is for.
void refuse_empty_values(CLI::App& app) {
  const auto check = [](const std::string& text) {
    return text.empty() ? std::string("(empty): a value is needed") : std::string();
  };
  for (CLI::Option* option : app.get_options()) {
    if (option->get_items_expected_max() > 0) option->transform(CLI::Validator(check, ""));
  }
  for (CLI::App* command : app.get_subcommands({})) refuse_empty_values(*command);
}

OptionDescription describe(const CLI::Option& option) {
  OptionDescription description;
  for (const std::string& name : option.get_snames()) description.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) description.names.push_back("--" + name);
  if (option.get_positional()) description.names = {option.get_name(true, false)};
  if (option.get_items_expected_max() > 0) description.value = option.get_type_name();
  description.description = option.get_description();
  description.default_value = option.get_default_str();
  description.required = option.get_required();
  description.repeatable = option.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll;
  return description;
}

CommandDescription describe(const CLI::App& command) {
  CommandDescription description{full_name(command), command.get_description(), command.get_footer(), {}, {}, {}};
  for (const CLI::Option* option : command.get_options()) {
    (option->get_positional() ? description.arguments : description.options).push_back(describe(*option));
  }
  for (const CLI::App* below : command.get_subcommands({})) description.commands.push_back(describe(*below));
  return description;
}

/// What was wrong, what was probably meant, and where to look.
std::string mistake(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& command = chosen(app);
  const bool extra = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr && !app.remaining(true).empty();
  return fmt::format("{} {} --help lists what is allowed",
                     extra ? unexpected(app, command) : error.what() + std::string(";"), full_name(command));
}

}  // namespace

const Option& Option::required() const {
  option_->required();
  return *this;
}

const Option& Option::type_name(const std::string& name) const {
  option_->type_name(name);
  return *this;
}

const Option& Option::show_default() const {
  option_->capture_default_str();
  return *this;
}

const Option& Option::show_default(const std::string& text) const {
  option_->default_str(text);
  return *this;
}

const Option& Option::check(const std::function<std::string(const std::string&)>& mistake) const {
  option_->check(CLI::Validator([mistake](const std::string& text) { return mistake(text); }, ""));
  return *this;
}

Command Command::add_command(const std::string& name, const std::string& description, Action run) const {
  CLI::App* command = app_->add_subcommand(name, description);
  command->callback([chosen = chosen_, run = std::move(run)] { *chosen = run; });
  return {command, chosen_};
}

bool Command::given(const std::string& option) const { return app_->count(option) > 0; }

Command Command::add_group(const std::string& name, const std::string& description) const {
  CLI::App* group = app_->add_subcommand(name, description);
  group->require_subcommand(0, 1);  // so that the name of an unknown one shows
  group->callback([group] {
    if (!group->get_subcommands().empty()) return;
    std::vector<std::string> names;
    for (const CLI::App* command : group->get_subcommands({})) names.push_back(command->get_name());
    throw CLI::RequiredError(fmt::format("{}: {}", group->get_name(), fmt::join(names, " or ")));
  });
  return {group, chosen_};
}

Option Command::add_text(const std::string& name, std::string& value, const std::string& description) const {
  return Option(app_->add_option(name, value, description));
}

Option Command::add_text(const std::string& name, std::optional<std::string>& value,
                         const std::string& description) const {
  return Option(app_->add_option(name, value, description));
}

Option Command::add_texts(const std::string& name, std::vector<std::string>& values,
                          const std::string& description) const {
  return Option(app_->add_option(name, values, description)
                    ->allow_extra_args(false)
                    ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll));
}

Option Command::add_arguments(const std::string& name, std::vector<std::string>& values,
                              const std::string& description) const {
  return Option(app_->add_option(name, values, description)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll));
}

Option Command::add_flag(const std::string& name, bool& value, const std::string& description) const {
  return Option(app_->add_flag(name, value, description));
}

Option Command::add_number(const std::string& name, double& value, double least, double most,
                           const std::string& description) const {
  return add_limited(*app_, name, value, least, most, description, "number");
}

Option Command::add_number(const std::string& name, std::optional<double>& value, double least, double most,
                           const std::string& description) const {
  return add_limited(*app_, name, value, least, most, description, "number");
}

Option Command::add_integer(const std::string& name, int& value, int least, int most,
                            const std::string& description) const {
  return add_limited(*app_, name, value, least, most, description, "whole number");
}

Option Command::add_integer(const std::string& name, std::uint64_t& value, std::uint64_t least, std::uint64_t most,
                            const std::string& description) const {
  return add_limited(*app_, name, value, least, most, description, "whole number");
}

Option Command::add_named(const std::string& name, const std::vector<std::string>& names,
                          const std::function<void(std::size_t)>& set, const std::string& description) const {
  const auto index_of = [names](const std::string& text) {
    return static_cast<std::size_t>(std::find(names.begin(), names.end(), text) - names.begin());
  };
  CLI::Option* option = app_->add_option_function<std::string>(
      name, [set, index_of](const std::string& text) { set(index_of(text)); }, description);
  option->type_name(fmt::format("{}", fmt::join(names, "|")))->default_str(names.front());
  return Option(option).check([names, index_of](const std::string& text) {
    return index_of(text) < names.size() ? ""
                                         : fmt::format("{}: {} is allowed", excerpt(text), fmt::join(names, " or "));
  });
}

CommandParser::CommandParser(const std::string& name, const std::string& description, const std::string& version,
                             const std::string& footer)
    : app_(std::make_unique<CLI::App>(description, name)) {
  app_->option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  app_->set_version_flag("--version", fmt::format("{} {}", name, version));
  app_->require_subcommand(0, 1);  // that there is one is checked below: the name of an unknown one is worth a word
  app_->footer(footer);
}

CommandParser::~CommandParser() = default;

CommandDescription CommandParser::description() const { return describe(*app_); }

std::optional<Action> CommandParser::parse(int argc, char** argv) {
  try {
    refuse_empty_values(*app_);
    app_->parse(argc, argv);
    if (!chosen_) throw CLI::RequiredError("A command");
    return chosen_;
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {  // help or version
      app_->exit(error);
      return std::nullopt;
    }
    throw UsageError(mistake(*app_, error));
  }
}

}  // namespace pyrasim::cli
