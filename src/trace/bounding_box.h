// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "numeric/scalar.h"

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
  glm::dvec3 center() const { return lower * 0.5 + upper * 0.5; }
  /// Half of the surface's area; 0 for an empty box.
  double half_area() const {
    if (!(lower.x <= upper.x)) return 0;
    const glm::dvec3 size = upper - lower;
    return size.x * size.y + size.y * size.z + size.z * size.x;
  }
  /// Grows by `roundings` roundings of the largest coordinate in a format of relative spacing `spacing`. The tests of
  /// boxes and surfaces err by a few roundings each; with the margin a ray that a surface counts as hit never misses
  /// the box around it, so that results do not depend on the hierarchy.
  void pad(double spacing, double roundings) {
    double largest = 0;
    for (int axis = 0; axis < 3; ++axis) {
      largest = std::max({largest, std::abs(lower[axis]), std::abs(upper[axis])});
    }
    lower -= glm::dvec3(largest * spacing * roundings);
    upper += glm::dvec3(largest * spacing * roundings);
  }
};

}  // namespace pyrasim
