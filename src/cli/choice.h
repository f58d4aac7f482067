// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <string>
#include <utility>
#include <vector>

namespace pyrasim::cli {

/// An option that sets `value` to one of `choices` by its name; the first is the default.
template <class Value>
CLI::Option* add_choice(CLI::App& command, const std::string& name, Value& value,
                        const std::vector<std::pair<std::string, Value>>& choices, const std::string& description) {
  std::vector<std::string> names;
  names.reserve(choices.size());
  for (const auto& choice : choices) names.push_back(choice.first);
  const auto set = [&value, choices](const std::string& text) {
    for (const auto& [choice, meaning] : choices) {
      if (choice == text) value = meaning;
    }
  };
  const auto check = [names](const std::string& text) {
    for (const std::string& choice : names) {
      if (choice == text) return std::string();
    }
    return fmt::format("{}: {} is allowed", text, fmt::join(names, " or "));
  };
  return command.add_option_function<std::string>(name, set, description)
      ->check(CLI::Validator(check, ""))
      ->type_name(fmt::format("{}", fmt::join(names, "|")))
      ->default_str(names.front());
}

}  // namespace pyrasim::cli
