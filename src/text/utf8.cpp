// SPDX-License-Identifier: Apache-2.0
#include "text/utf8.h"

namespace pyrasim {
namespace {

/// What a first byte says of its character.
struct Lead {
  std::size_t more = 0;  ///< bytes that follow
  char32_t bits = 0;     ///< of the code point
  unsigned least =
      0x80U;  ///< the second byte's limits: they exclude long forms, surrogates and what is beyond U+10FFFF
  unsigned most = 0xBFU;
};

std::optional<Lead> lead_of(unsigned byte) {
  if (byte < 0x80U) return Lead{0, byte};
  if (byte >= 0xC2U && byte < 0xE0U) return Lead{1, byte & 0x1FU};
  if (byte >= 0xE0U && byte < 0xF0U)
    return Lead{2, byte & 0x0FU, byte == 0xE0U ? 0xA0U : 0x80U, byte == 0xEDU ? 0x9FU : 0xBFU};
  if (byte >= 0xF0U && byte < 0xF5U)
    return Lead{3, byte & 0x07U, byte == 0xF0U ? 0x90U : 0x80U, byte == 0xF4U ? 0x8FU : 0xBFU};
  return std::nullopt;
}

}  // namespace

std::optional<char32_t> next_code_point(std::string_view text, std::size_t& position) {
  std::optional<Lead> lead = lead_of(static_cast<unsigned char>(text[position++]));
  if (!lead) return std::nullopt;
  for (; lead->more > 0; --lead->more, ++position) {
    const unsigned byte = position < text.size() ? static_cast<unsigned char>(text[position]) : 0U;
    if (byte < lead->least || byte > lead->most) return std::nullopt;
    lead->bits = lead->bits << 6U | (byte & 0x3FU);
    lead->least = 0x80U;
    lead->most = 0xBFU;
  }
  return lead->bits;
}

std::string valid_utf8(std::string_view text) {
  std::string result;
  for (std::size_t position = 0; position < text.size();) {
    const std::size_t begin = position;
    const bool valid = next_code_point(text, position).has_value();
    result += valid ? text.substr(begin, position - begin) : replacement_character;
  }
  return result;
}

}  // namespace pyrasim
