// SPDX-License-Identifier: Apache-2.0
#include "cli/man_page.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace pyrasim::cli {
namespace {

/// `text` as roff shows it: hyphens that can be copied into a shell, and nothing taken for a request.
std::string shown(std::string_view text) {
  std::string shown;
  bool line_begins = true;
  for (const char letter : text) {
    if (line_begins && (letter == '.' || letter == '\'')) shown += "\\&";
    line_begins = letter == '\n';
    if (letter == '-') {
      shown += "\\-";
    } else if (letter == '\\') {
      shown += "\\e";
    } else {
      shown += letter;
    }
  }
  return shown;
}

std::string bold(std::string_view text) { return fmt::format("\\fB{}\\fR", shown(text)); }
std::string italic(std::string_view text) { return fmt::format("\\fI{}\\fR", shown(text)); }

/// "pyrasim level [OPTION]... [SCENE]"
std::string synopsis(const CommandDescription& command) {
  std::string text = bold(command.path) + " [" + italic("OPTION") + "]...";
  for (const OptionDescription& argument : command.arguments) {
    const std::string name = italic(argument.names.front());
    text += " " + (argument.required ? name : "[" + name + "]");
  }
  return text;
}

std::string paragraph(const OptionDescription& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.names) names.push_back(option.positional() ? italic(name) : bold(name));
  std::string text = fmt::format(".TP\n{}", fmt::join(names, ", "));
  if (!option.positional() && !option.value.empty()) text += " " + italic(option.value);
  text += "\n" + shown(option.description);
  if (!option.positional() && !option.default_value.empty()) {
    text += "\n(default: " + shown(option.default_value) + ")";
  }
  return text + "\n";
}

std::string options_of(const CommandDescription& command, bool with_help) {
  std::string text;
  for (const OptionDescription& argument : command.arguments) text += paragraph(argument);
  for (const OptionDescription& option : command.options) {
    if (with_help || option.names.back() != "--help") text += paragraph(option);
  }
  return text;
}

}  // namespace

std::string man_page(const CommandDescription& program, std::string_view version) {
  const std::string& about = program.description;  // "pyrasim: what for.\nWhat it does."
  const std::size_t line_end = std::min(about.find('\n'), about.size());
  const std::size_t begin = about.starts_with(program.path + ": ") ? program.path.size() + 2 : 0;
  std::string title = program.path;
  std::transform(title.begin(), title.end(), title.begin(), [](unsigned char c) { return std::toupper(c); });
  std::string text =
      fmt::format(".TH {} 1 \"\" \"{} {}\" \"User Commands\"\n.SH NAME\n{} \\- {}\n.SH SYNOPSIS\n", title, program.path,
                  version, program.path, shown(about.substr(begin, line_end - begin)));
  text += fmt::format("{} {} [{}]...\n", bold(program.path), italic("COMMAND"), italic("OPTION"));
  text += fmt::format(".SH DESCRIPTION{}\n.SH OPTIONS\n{}.SH COMMANDS\n", shown(about.substr(line_end)),
                      options_of(program, true));
  for (const CommandDescription* command : with_commands_below(program)) {
    if (!command->commands.empty()) continue;
    text += fmt::format(".SS {}\n{}\n.PP\n{}\n{}", shown(command->name()), synopsis(*command),
                        shown(command->description), options_of(*command, false));
  }
  return text + fmt::format(".SH EXIT STATUS\n{}\n", shown(program.footer));
}

}  // namespace pyrasim::cli
