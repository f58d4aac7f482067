// SPDX-License-Identifier: Apache-2.0
// On which side of a line a point of the plane is, without rounding errors.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace pyrasim {

/// Points of a plane whose products neither overflow nor underflow: all coordinates are at most 2^400 in magnitude and
/// multiples of 2^-537.
using PlanePoints = std::vector<glm::dvec2>;

/// The corners of a polygon in space, seen along the axis that its plane faces most, and scaled by a power of two. They
/// are exact but where a coordinate is 2^-884 times smaller than the largest one.
PlanePoints project(std::span<const glm::dvec3> corners);

/// 1 where a, b and c turn left (counterclockwise), -1 where they turn right, 0 where they lie on one line.
int orientation(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c);

/// The sign of a polygon's area: 1 where it runs counterclockwise.
int winding(const PlanePoints& corners);

}  // namespace pyrasim
