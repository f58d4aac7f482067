// SPDX-License-Identifier: Apache-2.0
#include "surface/plane_distance.h"

#include <algorithm>
#include <cmath>

#include "numeric/vectors.h"
#include "surface/error_bounds.h"

namespace pyrasim {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double offset_error(const BoundingPlane& plane, const RoundingUnits& rounding) {
  return rounding.relative * std::abs(plane.offset) + rounding.absolute + plane.written;
}

/// Of n . d. The compensated sum adds 5u^2 of its terms, fixed point rounds two products instead; here it is summed
/// plainly, in double.
double approach_error(const BoundingPlane& plane, const Vector<double>& direction, const RoundingUnits& rounding) {
  const double u = rounding.relative;
  const double a = rounding.absolute;
  const auto n = magnitudes(plane.normal);
  const auto d = magnitudes(direction);
  return second_order(rounding) *
             (u * (1 + 5 * u) * dot(n, d) + (a + 0x1p-53 * 22 * largest(n) + plane.tilt) * sum(d) + 3 * a) +
         u * std::abs(dot(plane.normal, direction));
}

}  // namespace

/// Offset and n . d each known to its error, and the quotient's rounding.
DistanceRange plane_distance_range(const BoundingPlane& plane, const Vector<double>& direction,
                                   const RoundingUnits& rounding) {
  const double u = rounding.relative;
  const double a = rounding.absolute;
  const double approach = std::abs(dot(plane.normal, direction));
  const double by_approach = approach_error(plane, direction, rounding);
  const double offset = std::abs(plane.offset);
  const double by_offset = offset_error(plane, rounding);
  DistanceRange range{std::max(0.0, (offset - by_offset) / (approach + by_approach) * (1 - u) - a), infinity};
  if (approach > by_approach) range.highest = (offset + by_offset) / (approach - by_approach) * (1 + u) + a;
  return range;
}

bool certain_side(const BoundingPlane& plane, const RoundingUnits& rounding) {
  return std::abs(plane.offset) > offset_error(plane, rounding);
}

DistanceRange signed_plane_distance_range(const BoundingPlane& plane, const Vector<double>& direction,
                                          const RoundingUnits& rounding) {
  const DistanceRange size = plane_distance_range(plane, direction, rounding);
  if (size.highest == infinity || !certain_side(plane, rounding)) return {-size.highest, size.highest};
  const bool ahead = (plane.offset < 0) == (dot(plane.normal, direction) < 0);
  return ahead ? size : DistanceRange{-size.highest, -size.lowest};
}

PlaneError plane_error(const BoundingPlane& plane, const RoundingUnits& rounding) {
  const double u = rounding.relative;
  const double a = rounding.absolute;
  const double size = largest(plane.normal);
  const double offset = std::abs(plane.offset);
  const double own = 4 * u + (a + plane.written) / offset;
  const double relative = if_of_use(4 * std::max(own, std::sqrt(u)), rounding);
  // n . d errs by so much of the length of d.
  const double of_length = 3 * (2 * u + 22 * 0x1p-53) * size + 8 * a;
  const double length = offset * relative / (8 * of_length);
  return {relative, std::isfinite(relative) ? length * length : 0};
}

}  // namespace pyrasim
