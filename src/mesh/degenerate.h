// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>

namespace pyrasim {

/// Whether three points make no triangle: the smallest height is no larger than what rounding the coordinates to double
/// moves a point by. The answer does not change when all coordinates are multiplied by one number.
bool is_degenerate(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

}  // namespace pyrasim
