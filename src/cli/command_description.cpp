// SPDX-License-Identifier: Apache-2.0
#include "cli/command_description.h"

#include <algorithm>

#include "cli/command.h"

namespace pyrasim::cli {

std::vector<std::string> OptionDescription::choices() const {
  std::vector<std::string> words;
  for (const std::string& word : split(value, '|')) {
    const bool literal = std::all_of(word.begin(), word.end(), [](char letter) {
      return (letter >= 'a' && letter <= 'z') || (letter >= '0' && letter <= '9') || letter == '_';
    });
    if (literal && !word.empty()) words.push_back(word);
  }
  return words;
}

bool OptionDescription::takes_file() const {
  if (positional()) return choices().empty();
  return value.starts_with("FILE") || value.starts_with("IMAGE");
}

std::vector<const CommandDescription*> with_commands_below(const CommandDescription& program) {
  std::vector<const CommandDescription*> all{&program};
  for (const CommandDescription& command : program.commands) {
    const auto below = with_commands_below(command);
    all.insert(all.end(), below.begin(), below.end());
  }
  return all;
}

}  // namespace pyrasim::cli
