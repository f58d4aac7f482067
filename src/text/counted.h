// SPDX-License-Identifier: Apache-2.0
// Numbers of things in sentences.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace pyrasim {

/// The word that goes with so many things: "is" or "are".
inline std::string_view of_number(std::uint64_t number, std::string_view one, std::string_view several) {
  return number == 1 ? one : several;
}

/// "1 ray", "2 rays": of a thing whose plural has an s.
inline std::string counted(std::uint64_t number, std::string_view thing) {
  return fmt::format("{} {}{}", number, thing, of_number(number, "", "s"));
}

}  // namespace pyrasim
