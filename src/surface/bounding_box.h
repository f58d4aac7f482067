// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "numeric/vectors.h"

namespace pyrasim {

/// An axis-aligned box; empty until something is put in. Lengths in the scene's units.
struct BoundingBox {
  glm::dvec3 lower{std::numeric_limits<double>::infinity()};
  glm::dvec3 upper{-std::numeric_limits<double>::infinity()};

  void include(const glm::dvec3& point) {
    for (int axis = 0; axis < 3; ++axis) {
      lower[axis] = std::min(lower[axis], point[axis]);
      upper[axis] = std::max(upper[axis], point[axis]);
    }
  }
  void include(const BoundingBox& box) {
    for (int axis = 0; axis < 3; ++axis) {
      lower[axis] = std::min(lower[axis], box.lower[axis]);
      upper[axis] = std::max(upper[axis], box.upper[axis]);
    }
  }
  /// The largest magnitude of a coordinate in it.
  double reach() const { return std::max(largest(lower), largest(upper)); }
  glm::dvec3 center() const { return lower * 0.5 + upper * 0.5; }
  /// The area that a ray along x sees; 0 for an empty box.
  double frontal_area() const { return lower.x <= upper.x ? (upper.y - lower.y) * (upper.z - lower.z) : 0; }
  /// Half of its surface: what rays from anywhere see of it on average is in proportion; 0 for an empty box.
  double half_surface() const {
    if (!(lower.x <= upper.x)) return 0;
    const glm::dvec3 sides = upper - lower;
    return sides.x * sides.y + sides.y * sides.z + sides.z * sides.x;
  }
};

template <class Points>
BoundingBox box_of(const Points& points) {
  BoundingBox box;
  for (const glm::dvec3& point : points) box.include(point);
  return box;
}

}  // namespace pyrasim
