// SPDX-License-Identifier: Apache-2.0
// What the command line consists of, told apart from its parser: the manual page and the shells' completion are made
// from it.
#pragma once

#include <string>
#include <vector>

namespace pyrasim::cli {

/// An option, or an argument that is known by its position.
struct OptionDescription {
  std::vector<std::string> names;  ///< "-o" and "--output"; of an argument one, "SCENE"
  std::string value;               ///< what stands for its value, "FILE" or "mean|drop"; empty: it takes none
  std::string description;
  std::string default_value;  ///< empty: none, or none that is shown
  bool required = false;
  bool repeatable = false;

  bool positional() const { return !names.front().starts_with('-'); }
  /// The words that its value is one of, as far as they are known: "auto" of "L|auto". What a user replaces is in
  /// capitals.
  std::vector<std::string> choices() const;
  /// Whether its value names a file.
  bool takes_file() const;
};

struct CommandDescription {
  std::string path;  ///< "pyrasim study numerics"
  std::string description;
  std::string footer;  ///< of the program: its exit codes
  std::vector<OptionDescription> arguments;
  std::vector<OptionDescription> options;
  std::vector<CommandDescription> commands;

  /// "numerics"
  std::string name() const { return path.substr(path.rfind(' ') + 1); }
};

/// `program` and all commands below it, each before those below it.
std::vector<const CommandDescription*> with_commands_below(const CommandDescription& program);

}  // namespace pyrasim::cli
