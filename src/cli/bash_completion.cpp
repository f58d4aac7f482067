// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/completion.h"

namespace pyrasim::cli {
namespace {

/// Completes `word`, whose place the loop and the two `if` work out: below `command`, perhaps as the value of `option`.
/// Readline cuts words at "=", so that `--option=value` comes as three.
constexpr std::string_view frame = R"(# bash completion for {0}, made by `{0} completion bash`
_{0}() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} option=${{COMP_WORDS[COMP_CWORD - 1]}} command={0} words= files= i
  for ((i = 1; i < COMP_CWORD; ++i)); do
    case "$command ${{COMP_WORDS[i]}}" in
      {1}) command+=" ${{COMP_WORDS[i]}}" ;;
    esac
  done
  if [[ $word == = ]]; then
    word=
  elif [[ $option == = ]]; then
    option=${{COMP_WORDS[COMP_CWORD - 2]}}
  fi
  case "$command $option" in
{2}    *)
      case "$command ${{word:0:1}}" in
{3}      esac
      ;;
  esac
  COMPREPLY=()
  [[ -z $words ]] || mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
  if [[ -n $files ]]; then
    compopt -o filenames 2>/dev/null
    mapfile -t -O "${{#COMPREPLY[@]}}" COMPREPLY < <(compgen -f -- "$word")
  fi
}}
complete -F _{0} {0}
)";

/// "'pyrasim study' | 'pyrasim study numerics'": all commands but the program itself.
std::string command_patterns(const CommandDescription& program) {
  std::vector<std::string> patterns;
  for (const CommandDescription* command : with_commands_below(program)) {
    if (command != &program) patterns.push_back(fmt::format("'{}'", command->path));
  }
  return fmt::format("{}", fmt::join(patterns, " | "));
}

/// A branch for each option that takes a value: what that may be.
std::string value_branches(const CommandDescription& command) {
  std::string text;
  for (const OptionDescription& option : command.options) {
    if (option.value.empty()) continue;
    std::vector<std::string> patterns;
    for (const std::string& name : option.names) patterns.push_back(fmt::format("'{} {}'", command.path, name));
    const std::string words = fmt::format("words='{}'", fmt::join(option.choices(), " "));
    text += fmt::format("    {}) {} ;;\n", fmt::join(patterns, " | "), option.takes_file() ? "files=yes" : words);
  }
  return text;
}

/// Two branches for what else may follow the command: an option, or one of the rest.
std::string word_branches(const CommandDescription& command) {
  std::vector<std::string> options;
  for (const OptionDescription& option : command.options) options.push_back(option.names.back());
  std::vector<std::string> words;
  for (const CommandDescription& below : command.commands) words.push_back(below.name());
  bool files = false;
  for (const OptionDescription& argument : command.arguments) {
    for (const std::string& choice : argument.choices()) words.push_back(choice);
    files = files || argument.takes_file();
  }
  return fmt::format("        '{0} -') words='{1}' ;;\n        '{0} ' | '{0} '?) words='{2}'{3} ;;\n", command.path,
                     fmt::join(options, " "), fmt::join(words, " "), files ? " files=yes" : "");
}

}  // namespace

std::string bash_completion(const CommandDescription& program) {
  std::string values;
  std::string words;
  for (const CommandDescription* command : with_commands_below(program)) {
    values += value_branches(*command);
    words += word_branches(*command);
  }
  return fmt::format(fmt::runtime(frame), program.path, command_patterns(program), values, words);
}

}  // namespace pyrasim::cli
