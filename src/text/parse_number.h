// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <charconv>
#include <cstdlib>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>

namespace pyrasim {

/// Reads the whole of `word`, a leading plus included. A number too small or too large for its type is read as 0 or
/// infinity; an integer must fit.
template <class T>
bool parse_whole(std::string_view word, T& value) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if constexpr (std::is_floating_point_v<T>) {
    if (error == std::errc::result_out_of_range) value = std::strtod(std::string(word).c_str(), nullptr);
    return error != std::errc::invalid_argument && end == word.data() + word.size();
  }
  return error == std::errc() && end == word.data() + word.size();
}

}  // namespace pyrasim
