// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace pyrasim::hw {

/// The identifier code of VCD for a signal: printable characters, shortest first.
inline std::string vcd_code(std::size_t signal) {
  std::string text;
  do {
    text += static_cast<char>('!' + signal % 94);
    signal /= 94;
  } while (signal > 0);
  return text;
}

/// The signal of an identifier code.
inline std::size_t vcd_signal(std::string_view code) {
  std::size_t signal = 0;
  std::size_t weight = 1;
  for (const char digit : code) {
    signal += weight * static_cast<std::size_t>(digit - '!');
    weight *= 94;
  }
  return signal;
}

}  // namespace pyrasim::hw
