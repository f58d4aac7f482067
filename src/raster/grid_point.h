// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace pyrasim {

/// A point of the screen, counted in steps of the grid from the screen's upper left corner.
/// With 2^MAX_LEVEL steps a pixel side, row = mu 2^MAX_LEVEL + i 2^(MAX_LEVEL-L), column likewise with nu and j.
struct GridPoint {
  std::uint32_t row = 0;     ///< downwards
  std::uint32_t column = 0;  ///< to the right
  friend bool operator==(const GridPoint&, const GridPoint&) = default;
};

}  // namespace pyrasim
