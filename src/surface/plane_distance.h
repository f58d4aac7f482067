// SPDX-License-Identifier: Apache-2.0
// Where a ray meets the plane n . p = offset, at t = offset / n . d; what planes and surfaces bounded by planes share.
#pragma once

#include <limits>

#include "numeric/compensated.h"
#include "surface/distance_range.h"

namespace pyrasim {

/// The t > 0 at which the view ray meets the plane, or 0 where it runs parallel or away from it.
///
/// A grazing ray's n . d is what is left of terms that cancel: summed plainly it loses as many digits as the angle has
/// zeros. Compensated it is right to 1 ulp down to angles of 2^-P, and t, one division later, to 2. The offset, which
/// the observer's distance would spoil likewise, is worked out exactly and rounded once when the scene is prepared.
template <class Scalar>
Scalar plane_distance(const Vector<Scalar>& normal, Scalar offset, const Vector<Scalar>& direction) {
  const Scalar approach = compensated_dot(normal, direction);
  if (approach == Scalar(0)) return Scalar(0);
  const Scalar t = offset / approach;
  return t > Scalar(0) ? t : Scalar(0);
}

/// A plane as error bounds ask for it.
struct BoundingPlane {
  Vector<double> normal;
  double offset;
  double written;   ///< by how much the offset may lie from what the scene says, before it is rounded to the format
  double tilt = 0;  ///< likewise a component of the normal
};

/// In which range the exact |t| lies. `highest` is infinite where n . d may be 0.
DistanceRange plane_distance_range(const BoundingPlane& plane, const Vector<double>& direction,
                                   const RoundingUnits& rounding);
/// Whether the observer is certainly on the side of the plane that the offset's sign says.
bool certain_side(const BoundingPlane& plane, const RoundingUnits& rounding);
/// In which range the exact t lies, ahead or behind.
DistanceRange signed_plane_distance_range(const BoundingPlane& plane, const Vector<double>& direction,
                                          const RoundingUnits& rounding);

/// By what part of itself t errs on rays that meet a plane within some length: the closer to its horizon, the more.
struct PlaneError {
  double relative = std::numeric_limits<double>::infinity();
  double squared_length = 0;  ///< along a ray, up to which `relative` holds

  /// On the ray that meets it at t = `depth`.
  double at(double depth, double inverse_length_squared) const {
    return depth * depth <= squared_length * inverse_length_squared ? relative
                                                                    : std::numeric_limits<double>::infinity();
  }
  /// On all rays that meet it within `length`.
  double within(double length) const { return at(length, 1); }
};
PlaneError plane_error(const BoundingPlane& plane, const RoundingUnits& rounding);

}  // namespace pyrasim
