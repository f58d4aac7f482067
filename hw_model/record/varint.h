// SPDX-License-Identifier: Apache-2.0
// Whole numbers as bytes, small ones short: seven bits a byte, the lowest first; the eighth says that more follow.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace pyrasim::hw {

inline void append_varint(std::string& bytes, std::uint64_t number) {
  for (; number >= 0x80; number >>= 7U) bytes += static_cast<char>(number | 0x80);
  bytes += static_cast<char>(number);
}

/// The number at the beginning of `bytes`, cut off there; none where it is not whole, or has more than 64 bits.
inline std::optional<std::uint64_t> take_varint(std::string_view& bytes) {
  std::uint64_t number = 0;
  for (std::size_t k = 0; k < bytes.size() && k < 10; ++k) {
    const auto byte = static_cast<unsigned char>(bytes[k]);
    if (k == 9 && byte > 1) return std::nullopt;
    number |= std::uint64_t{byte & 0x7FU} << 7 * k;
    if (byte < 0x80) {
      bytes.remove_prefix(k + 1);
      return number;
    }
  }
  return std::nullopt;
}

/// Signed ones, small in either direction: 0, -1, 1, -2, 2 ... as 0, 1, 2, 3, 4 ...
inline std::uint64_t zigzag(std::int64_t number) {
  return static_cast<std::uint64_t>(number) << 1U ^ static_cast<std::uint64_t>(number >> 63);
}
inline std::int64_t from_zigzag(std::uint64_t number) {
  return static_cast<std::int64_t>(number >> 1U ^ (~(number & 1U) + 1U));
}

}  // namespace pyrasim::hw
