// SPDX-License-Identifier: Apache-2.0
#include "text/printable.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

namespace pyrasim {
namespace {

constexpr std::string_view ellipsis = "\u2026";
constexpr std::size_t message_head = 800;  ///< bytes of an overlong message that are kept
constexpr std::size_t message_tail = 300;

/// A character at the front of a text.
struct Character {
  std::uint32_t code = 0;
  std::size_t size = 0;  ///< bytes; 0: the first byte is not part of well-formed UTF-8
};

bool continues(char byte) { return (static_cast<unsigned char>(byte) & 0xc0U) == 0x80; }

/// RFC 3629: neither overlong forms nor surrogates nor anything above U+10FFFF.
Character first_character(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text[0]);
  if (lead < 0x80) return {lead, 1};
  if (lead < 0xc2 || lead > 0xf4) return {};
  const std::size_t size = lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : 4;
  if (text.size() < size) return {};
  std::uint32_t code = lead & (0x7fU >> size);
  for (const char byte : text.substr(1, size - 1)) {
    if (!continues(byte)) return {};
    code = code << 6U | (static_cast<unsigned char>(byte) & 0x3fU);
  }
  constexpr std::uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
  if (code < least[size] || code > 0x10ffff || (code >= 0xd800 && code <= 0xdfff)) return {};
  return {code, size};
}

bool steers_terminal(std::uint32_t code) {
  return code < 0x20 || (code >= 0x7f && code <= 0x9f) || code == 0x061c || code == 0x200e || code == 0x200f ||
         (code >= 0x2028 && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069);
}

/// Cuts the first character off `text` and returns it as a terminal may show it.
std::string next_printable(std::string_view& text) {
  const Character character = first_character(text);
  const std::string_view bytes = text.substr(0, std::max<std::size_t>(character.size, 1));
  text.remove_prefix(bytes.size());
  if (character.size == 0) return fmt::format("\\x{:02x}", static_cast<unsigned char>(bytes[0]));
  if (steers_terminal(character.code)) return fmt::format("\\u{:04x}", character.code);
  return std::string(bytes);
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

std::string message_line(std::string_view text) {
  if (text.size() <= message_head + message_tail) return one_line(text);
  std::size_t head = message_head;
  while (head > 0 && continues(text[head])) --head;
  std::size_t tail = text.size() - message_tail;
  while (tail < text.size() && continues(text[tail])) ++tail;
  return one_line(text.substr(0, head)).append(" ").append(ellipsis).append(" ") + one_line(text.substr(tail));
}

std::size_t first_not_utf8(std::string_view text) {
  std::size_t offset = 0;
  while (offset < text.size()) {
    const std::size_t size = first_character(text.substr(offset)).size;
    if (size == 0) return offset;
    offset += size;
  }
  return text.size();
}

}  // namespace pyrasim
