// SPDX-License-Identifier: Apache-2.0
#include "mesh/degenerate.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "numeric/vectors.h"

namespace pyrasim {

bool is_degenerate(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const double size = std::max({largest(a), largest(b), largest(c)});
  if (!(size > 0)) return true;
  // Coordinates now are at most 1: nothing below overflows, and one of them is exactly 1 in magnitude.
  const glm::dvec3 p = a / size;
  const glm::dvec3 q = b / size;
  const glm::dvec3 r = c / size;
  const double longest = std::max({glm::length(q - p), glm::length(r - p), glm::length(r - q)});
  const double twice_area = glm::length(glm::cross(q - p, r - p));
  constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();
  return twice_area <= rounding * longest;
}

}  // namespace pyrasim
