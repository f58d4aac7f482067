// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <string>

namespace pyrasim::cli {

/// Sets `number` to what `text` says in decimal digits; false, and nothing set, unless that is from `least` to `most`.
template <class Number>
bool read_whole_number(const std::string& text, Number least, Number most, Number& number) {
  Number read = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), read);
  if (error != std::errc() || end != text.data() + text.size() || read < least || read > most) return false;
  number = read;
  return true;
}

/// An option that sets `value`. The parser's own conversion lets a number that is negative or too large wrap, and takes
/// 010 for 8.
template <class Number>
CLI::Option* add_whole_number(CLI::App& command, const std::string& name, Number& value, Number least, Number most,
                              const std::string& description) {
  const auto set = [&value, least, most](const std::string& text) { read_whole_number(text, least, most, value); };
  const auto check = [least, most](const std::string& text) {
    Number ignored = 0;
    return read_whole_number(text, least, most, ignored)
               ? std::string()
               : fmt::format("{}: a whole number from {} to {} is allowed", text, least, most);
  };
  return command.add_option_function<std::string>(name, set, description)
      ->check(CLI::Validator(check, ""))
      ->type_name("N");
}

/// --threads, where `more` says what else is to be said.
inline CLI::Option* add_threads_option(CLI::App& command, int& threads, const std::string& more = "") {
  return add_whole_number(command, "--threads", threads, 0, 1024,
                          "0: one for each core; " + more + "results do not depend on it")
      ->default_str(std::to_string(threads));
}

}  // namespace pyrasim::cli
