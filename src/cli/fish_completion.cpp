// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/command.h"
#include "cli/completion.h"

namespace pyrasim::cli {
namespace {

std::string quoted(const std::string& text) {
  std::string quoted = "'";
  for (const char letter : text) {
    if (letter == '\'' || letter == '\\') quoted += '\\';
    quoted += letter;
  }
  return quoted + "'";
}

/// A fish command that succeeds where the words so far are those of `command`, and of none below it.
std::string condition(const CommandDescription& command) {
  const std::vector<std::string> path = split(command.path, ' ');
  if (path.size() == 1) return "__fish_use_subcommand";
  std::string text = fmt::format("__fish_seen_subcommand_from {}", path[1]);
  for (std::size_t k = 2; k < path.size(); ++k) text += fmt::format("; and __fish_seen_subcommand_from {}", path[k]);
  std::vector<std::string> below;
  for (const CommandDescription& each : command.commands) below.push_back(each.name());
  if (!below.empty()) text += fmt::format("; and not __fish_seen_subcommand_from {}", fmt::join(below, " "));
  return text;
}

/// The flags of `complete` that say what may be its value.
std::string value_flags(const OptionDescription& option) {
  if (option.value.empty()) return "";
  if (option.takes_file()) return option.positional() ? " -F" : " -r -F";
  const auto choices = option.choices();
  const std::string kind = option.positional() ? "" : " -x";
  return choices.empty() ? kind : fmt::format("{} -a '{}'", kind, fmt::join(choices, " "));
}

std::string name_flags(const OptionDescription& option) {
  std::string text;
  if (option.positional()) return text;
  for (const std::string& name : option.names) {
    text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  }
  return text;
}

}  // namespace

std::string fish_completion(const CommandDescription& program) {
  std::string text =
      fmt::format("# fish completion for {0}, made by `{0} completion fish`\ncomplete -c {0} -f\n", program.path);
  for (const CommandDescription* command : with_commands_below(program)) {
    const std::string begin = fmt::format("complete -c {} -n '{}'", program.path, condition(*command));
    for (const CommandDescription& below : command->commands) {
      text += fmt::format("{} -a {} -d {}\n", begin, below.name(), quoted(below.description));
    }
    for (const auto* options : {&command->arguments, &command->options}) {
      for (const OptionDescription& option : *options) {
        text +=
            fmt::format("{}{}{} -d {}\n", begin, name_flags(option), value_flags(option), quoted(option.description));
      }
    }
  }
  return text;
}

}  // namespace pyrasim::cli
