// SPDX-License-Identifier: Apache-2.0
// By what part of itself a computed t can differ from the exact one on any ray: what can be known of a surface before
// there is a ray. Coarser than distance_range.h, and free: most hits are told apart by it.
#pragma once

#include "intersect/rounding_units.h"
#include "intersect/surface.h"

namespace pyrasim {

/// |t - exact t| <= the result * t for every ray on which the kernel finds a hit, and distance_range() lies within;
/// infinity where that is not less than 2^-8. `surface` is as prepared, not yet rounded to the format.
double relative_error(const SphereSurface<double>& surface, const RoundingUnits& rounding);
double relative_error(const TriangleSurface<double>& surface, const RoundingUnits& rounding);

/// The same for rays that meet the plane within some length: the closer to its horizon, the larger the error.
struct PlaneError {
  double relative;
  double squared_length;  ///< up to which `relative` holds
};
PlaneError relative_error(const PlaneSurface<double>& surface, const RoundingUnits& rounding);

}  // namespace pyrasim
