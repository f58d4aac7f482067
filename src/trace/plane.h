// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "trace/surface.h"

namespace pyrasim {

/// The t > 0 at which the view ray meets the plane, or 0 where it runs parallel or away from it.
template <class Scalar>
Scalar intersect_plane(const PlaneSurface<Scalar>& plane, const Vector<Scalar>& direction) {
  const Scalar approach = dot(plane.shading.normal, direction);
  if (approach == Scalar(0)) return Scalar(0);
  const Scalar t = plane.offset / approach;
  return t > Scalar(0) ? t : Scalar(0);
}

}  // namespace pyrasim
