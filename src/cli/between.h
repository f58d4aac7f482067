// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <string>

namespace pyrasim::cli {

/// Like CLI::Range, but NaN is outside too, and the limits show as they are.
inline CLI::Validator between(double least, double most) {
  const auto check = [=](const std::string& text) {
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool fits = error == std::errc() && end == text.data() + text.size() && number >= least && number <= most;
    return fits ? std::string() : fmt::format("{}: a number from {} to {} is allowed", text, least, most);
  };
  return {check, ""};
}

}  // namespace pyrasim::cli
