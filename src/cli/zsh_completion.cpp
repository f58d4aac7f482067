// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "cli/completion.h"

namespace pyrasim::cli {
namespace {

/// `text` inside single quotes, with a backslash before each of `special`.
std::string escaped(const std::string& text, std::string_view special) {
  std::string escaped;
  for (const char letter : text) {
    if (letter == '\'') {
      escaped += "'\\''";
      continue;
    }
    if (special.find(letter) != std::string_view::npos) escaped += '\\';
    escaped += letter;
  }
  return escaped;
}

std::string function_name(const CommandDescription& command) {
  std::string name = "_" + command.path;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

/// ":FILE:_files", ":mean|drop:(mean drop)", ":N: ": the value of an option or argument, as _arguments takes it.
std::string value_of(const OptionDescription& option) {
  if (option.value.empty()) return "";
  const auto choices = option.choices();
  const std::string action = choices.empty() ? " " : fmt::format("({})", fmt::join(choices, " "));
  return fmt::format(":{}:{}", escaped(option.positional() ? option.names.front() : option.value, ":\\"),
                     option.takes_file() ? "_files" : action);
}

/// "'(-o --output)'{-o+,--output=}'[picture to write]:IMAGE:_files'"
std::string option_specification(const OptionDescription& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.names) {
    const bool separate = option.value.empty();
    names.push_back(name + (separate ? "" : name.starts_with("--") ? "=" : "+"));
  }
  const std::string explanation = fmt::format("[{}]{}", escaped(option.description, "[]:\\"), value_of(option));
  const std::string before = option.repeatable ? "*" : fmt::format("({})", fmt::join(option.names, " "));
  if (names.size() == 1) return fmt::format("'{}{}{}'", before, names.front(), explanation);
  return fmt::format("'{}'{{{}}}'{}'", before, fmt::join(names, ","), explanation);
}

/// The function that completes what follows the name of `command`; it calls those of the commands below.
std::string function_of(const CommandDescription& command) {
  std::vector<std::string> specifications;
  for (const OptionDescription& option : command.options) specifications.push_back(option_specification(option));
  for (const OptionDescription& argument : command.arguments) {
    specifications.push_back(fmt::format("'{}{}'", argument.required ? "" : ":", value_of(argument)));
  }
  std::string names;
  std::string branches;
  for (const CommandDescription& below : command.commands) {
    names += fmt::format("\n    '{}:{}'", below.name(), escaped(below.description, ""));
    branches += fmt::format("\n    {}) {} ;;", below.name(), function_name(below));
  }
  if (command.commands.empty()) {
    return fmt::format("{}() {{\n  _arguments \\\n    {}\n}}\n", function_name(command),
                       fmt::join(specifications, " \\\n    "));
  }
  return fmt::format(
      "{0}() {{\n  local curcontext=$curcontext context state line\n  typeset -A opt_args\n"
      "  local -a commands=({1}\n  )\n  _arguments -C \\\n    {2} \\\n"
      "    '1: :->command' \\\n    '*:: :->rest'\n"
      "  [[ $state != command ]] || _describe -t commands command commands\n"
      "  [[ $state != rest ]] || case $words[1] in{3}\n  esac\n}}\n",
      function_name(command), names, fmt::join(specifications, " \\\n    "), branches);
}

}  // namespace

std::string zsh_completion(const CommandDescription& program) {
  std::string text =
      fmt::format("#compdef {0}\n# zsh completion for {0}, made by `{0} completion zsh`\n", program.path);
  for (const CommandDescription* command : with_commands_below(program)) text += function_of(*command);
  return text + fmt::format("{} \"$@\"\n", function_name(program));
}

}  // namespace pyrasim::cli
