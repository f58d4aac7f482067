// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "intersect/surface.h"
#include "numeric/compensated.h"

namespace pyrasim {

/// The t > 0 at which the view ray meets the plane, or 0 where it runs parallel or away from it.
///
/// A grazing ray's n . d is what is left of terms that cancel: summed plainly it loses as many digits as the angle has
/// zeros. Compensated it is right to 1 ulp down to angles of 2^-P, and t, one division later, to 2. The offset, which
/// the observer's distance would spoil likewise, is worked out exactly and rounded once when the scene is prepared.
template <class Scalar>
Scalar intersect_plane(const PlaneSurface<Scalar>& plane, const Vector<Scalar>& direction) {
  const Scalar approach = compensated_dot(plane.shading.normal, direction);
  if (approach == Scalar(0)) return Scalar(0);
  const Scalar t = plane.offset / approach;
  return t > Scalar(0) ? t : Scalar(0);
}

}  // namespace pyrasim
