// SPDX-License-Identifier: Apache-2.0
#include "cli/usage.h"

#include <fmt/format.h>

#include <algorithm>

#include "text/printable.h"

namespace pyrasim::cli {
namespace {

constexpr std::size_t longest_word = 64;  ///< of what is looked for among names

/// The fewest letters to insert, leave out, replace or exchange with their neighbour (optimal string alignment).
std::size_t edit_distance(const std::string& from, const std::string& to) {
  std::vector<std::vector<std::size_t>> distance(from.size() + 1, std::vector<std::size_t>(to.size() + 1));
  for (std::size_t i = 0; i <= from.size(); ++i) {
    for (std::size_t j = 0; j <= to.size(); ++j) {
      if (i == 0 || j == 0) {
        distance[i][j] = i + j;
        continue;
      }
      const std::size_t replaced = from[i - 1] == to[j - 1] ? 0 : 1;
      distance[i][j] = std::min({distance[i - 1][j] + 1, distance[i][j - 1] + 1, distance[i - 1][j - 1] + replaced});
      if (i > 1 && j > 1 && from[i - 1] == to[j - 2] && from[i - 2] == to[j - 1]) {
        distance[i][j] = std::min(distance[i][j], distance[i - 2][j - 2] + 1);
      }
    }
  }
  return distance[from.size()][to.size()];
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
  for (const CLI::App* each : command.get_subcommands([](const CLI::App*) { return true; })) {
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
  return fmt::format("{}: unknown {}{}", word, what, meant ? fmt::format("; did you mean {}?", *meant) : ";");
}

/// What nobody expected, by its likeliest cause: an option, or the name of a command.
std::string unexpected(const CLI::App& app, const CLI::App& command) {
  const std::vector<std::string> words = app.remaining(true);
  const auto option = std::find_if(words.begin(), words.end(), [](const auto& word) { return word.starts_with('-'); });
  if (option != words.end()) {
    return unknown(option->substr(0, option->find('=')), "option", option_names(command));
  }
  const std::vector<std::string> commands = command_names(command);
  if (!commands.empty()) return unknown(words.front(), "command", commands);
  return fmt::format("{}: not expected;", words.front());
}

}  // namespace

void refuse_empty_values(CLI::App& app) {
  for (CLI::Option* option : app.get_options()) {
    const auto check = [](const std::string& text) {
      return text.empty() ? std::string("(empty): a value is needed") : std::string();
    };
    // In front of the option's own checks, which transform() is for.
    if (option->get_items_expected_max() > 0) option->transform(CLI::Validator(check, ""));
  }
  for (CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) refuse_empty_values(*command);
}

std::string usage_mistake(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& command = chosen(app);
  const bool extra = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr && !app.remaining(true).empty();
  return message_line(fmt::format("{} {} --help lists what is allowed",
                                  extra ? unexpected(app, command) : error.what() + std::string(";"),
                                  full_name(command)));
}

std::optional<std::string> nearest(const std::string& word, const std::vector<std::string>& known) {
  if (word.size() > longest_word) return std::nullopt;
  std::optional<std::string> best;
  std::size_t least = word.size() / 3;
  for (const std::string& name : known) {
    const std::size_t distance = edit_distance(word, name);
    if (distance > least || (best && distance == least)) continue;
    best = name;
    least = distance;
  }
  return best;
}

}  // namespace pyrasim::cli
