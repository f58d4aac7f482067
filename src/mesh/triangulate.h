// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

namespace pyrasim {

struct Triangulation {
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< positions in the list of corners
  bool crossing = false;                                ///< the polygon crosses or covers itself
};

/// Cuts a polygon of at least three corners into triangles between its corners, which cover what it encloses, once. It
/// may be tilted, bend inwards, have corners on straight sides, repeated corners, and bridges to holes that are walked
/// there and back; and it may be bent out of its plane. The first corner and the direction of the list do not matter.
/// A polygon without an area has no triangles, or slivers alone. Time O(n^2) of the number of corners.
Triangulation triangulate(std::span<const glm::dvec3> corners);

/// What a file's reader says of so many such `polygons` that cross themselves.
std::string crossing_warning(std::size_t polygons, std::size_t first_line);

}  // namespace pyrasim
