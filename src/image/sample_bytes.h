// SPDX-License-Identifier: Apache-2.0
// Samples as bytes, the same on every machine.
#pragma once

#include <bit>
#include <cstdint>
#include <string>

namespace pyrasim {

/// Appends the four bytes of a float32, least significant first.
inline void append_float32_le(std::string& bytes, float sample) {
  const auto word = std::bit_cast<std::uint32_t>(sample);
  for (unsigned shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<char>((word >> shift) & 0xFFU));
}

/// The float32 in the four bytes at `bytes`: least significant first where `little_endian`, else last.
inline float float32_at(const char* bytes, bool little_endian) {
  std::uint32_t word = 0;
  for (int i = 0; i < 4; ++i) word = (word << 8U) | static_cast<unsigned char>(bytes[little_endian ? 3 - i : i]);
  return std::bit_cast<float>(word);
}

}  // namespace pyrasim
