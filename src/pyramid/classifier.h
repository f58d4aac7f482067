// SPDX-License-Identifier: Apache-2.0
// The pyramid's cases: what its four corner rays say about the object they hit.
#pragma once

#include "pyramid/pyramid.h"

namespace pyrasim {

enum class PyramidCase : std::uint8_t {
  empty,    ///< case 1: no ray hits an object. Case 4, an object that no corner ray sees, looks the same (decision D9)
  covered,  ///< case 2: all four rays hit the same object
  edge,     ///< case 3: at least one ray hits an object, and fewer than four hit that object
};
inline constexpr std::size_t pyramid_cases = 3;

constexpr PyramidCase classify(const CornerSamples& corners) {
  const std::uint32_t object = corners[0].object;
  if (corners[1].object != object || corners[2].object != object || corners[3].object != object) {
    return PyramidCase::edge;
  }
  return object == no_object ? PyramidCase::empty : PyramidCase::covered;
}

/// Whether a pyramid is split in four (case 3 above MAX_LEVEL; decision D1: the pixel is level 0).
constexpr bool subdivides(PyramidCase which, std::uint32_t level, int max_level) {
  return which == PyramidCase::edge && level < static_cast<std::uint32_t>(max_level);
}

}  // namespace pyrasim
