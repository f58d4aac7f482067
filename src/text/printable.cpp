// SPDX-License-Identifier: Apache-2.0
#include "text/printable.h"

#include <fmt/format.h>

#include <cstdint>

#include "text/utf8.h"

namespace pyrasim {
namespace {

constexpr std::string_view ellipsis = "\u2026";
constexpr std::size_t message_head = 800;  ///< bytes of an overlong message that are kept
constexpr std::size_t message_tail = 300;

bool continues(char byte) { return (static_cast<unsigned char>(byte) & 0xc0U) == 0x80; }

bool steers_terminal(char32_t code) {
  return is_control(code) || code == 0x061c || code == 0x200e || code == 0x200f || (code >= 0x2028 && code <= 0x202e) ||
         (code >= 0x2066 && code <= 0x2069);
}

/// Cuts the first character off `text` and returns it as a terminal may show it.
std::string next_printable(std::string_view& text) {
  std::size_t size = 0;
  const std::optional<char32_t> code = next_code_point(text, size);
  const std::string_view bytes = text.substr(0, size);
  text.remove_prefix(size);
  if (code) return steers_terminal(*code) ? fmt::format("\\u{:04x}", std::uint32_t{*code}) : std::string(bytes);
  std::string shown;
  for (const char byte : bytes) shown += fmt::format("\\x{:02x}", static_cast<unsigned char>(byte));
  return shown;
}

}  // namespace

std::string one_line(std::string_view text) {
  std::string result;
  while (!text.empty()) result += next_printable(text);
  return result;
}

std::string excerpt(std::string_view text, std::size_t longest) {
  std::string result;
  for (std::size_t length = 0; !text.empty();) {
    const std::string shown = next_printable(text);
    length += shown[0] == '\\' ? shown.size() : 1;
    if (length > longest) return result += ellipsis;
    result += shown;
  }
  return result;
}

std::string value_excerpt(std::string_view text) { return text.empty() ? "(empty)" : excerpt(text); }

std::string message_line(std::string_view text) {
  if (text.size() <= message_head + message_tail) return one_line(text);
  std::size_t head = message_head;
  while (head > 0 && continues(text[head])) --head;
  std::size_t tail = text.size() - message_tail;
  while (tail < text.size() && continues(text[tail])) ++tail;
  return one_line(text.substr(0, head)).append(" ").append(ellipsis).append(" ") + one_line(text.substr(tail));
}

std::size_t first_not_utf8(std::string_view text) {
  for (std::size_t offset = 0; offset < text.size();) {
    if (static_cast<unsigned char>(text[offset]) < 0x80U) {  // nearly all that there is in a long text
      ++offset;
      continue;
    }
    const std::size_t begin = offset;
    if (!next_code_point(text, offset)) return begin;
  }
  return text.size();
}

}  // namespace pyrasim
