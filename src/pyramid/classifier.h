// SPDX-License-Identifier: Apache-2.0
// The pyramid's cases: what its four corner rays say about the object they hit.
#pragma once

#include <array>
#include <string_view>

#include "pyramid/cell.h"

namespace pyrasim {

/// The article's cases 1 to 4.
enum class PyramidCase : std::uint8_t {
  empty,    ///< no ray hits an object, and none lies inside
  covered,  ///< all four rays hit the same object
  edge,     ///< at least one ray hits an object, and fewer than four hit that object
  hidden,   ///< no ray hits an object, yet one lies inside. Four corners cannot tell it from `empty` (decision D9)
};
inline constexpr std::array<std::string_view, 4> pyramid_case_names{"empty", "covered", "edge", "hidden"};
inline constexpr std::size_t pyramid_cases = pyramid_case_names.size();

/// What the four corners tell: one of the first three cases.
constexpr PyramidCase classify(const CornerSamples& corners) {
  const Seen& seen = corners[0].seen;
  if (corners[1].seen != seen || corners[2].seen != seen || corners[3].seen != seen) return PyramidCase::edge;
  return seen.object == no_object ? PyramidCase::empty : PyramidCase::covered;
}

/// Whether a pyramid is split in four: case 3 above MAX_LEVEL (decision D1: the pixel is level 0).
constexpr bool subdivides(PyramidCase which, const Cell& cell) {
  return which == PyramidCase::edge && cell.log2_side > 0;
}

}  // namespace pyrasim
