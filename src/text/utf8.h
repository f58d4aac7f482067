// SPDX-License-Identifier: Apache-2.0
// Text from outside, names above all, may be any bytes; what is written as UTF-8 must be UTF-8.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace pyrasim {

/// U+FFFD, which stands for what cannot be shown.
inline constexpr std::string_view replacement_character = "\xEF\xBF\xBD";

/// The code point that begins at `position`, which moves past it; none, and past the bytes that cannot be read
/// together, where that is not UTF-8 (RFC 3629: the shortest form, no surrogates, up to U+10FFFF).
std::optional<char32_t> next_code_point(std::string_view text, std::size_t& position);

/// `text` with U+FFFD where it is not UTF-8.
std::string valid_utf8(std::string_view text);

/// Whether `code_point` is a control character, C0 or C1: no glyph, but a command to some terminals.
constexpr bool is_control(char32_t code_point) {
  return code_point < 0x20 || (code_point >= 0x7F && code_point < 0xA0);
}

}  // namespace pyrasim
