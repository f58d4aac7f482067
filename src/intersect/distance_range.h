// SPDX-License-Identifier: Apache-2.0
// Where the exact hit lies, given the one that a datapath computed: forward error bounds of the kernels in sphere.h,
// plane.h and triangle.h, operation by operation. Worked out in double beside the datapath, for every format.
//
// Exact is what the scene says, decimal numbers as written, along the ray as it enters the kernels: the view vector's
// own rounding moves all surfaces alike.
#pragma once

#include "intersect/rounding_units.h"
#include "intersect/surface.h"

namespace pyrasim {

/// A range of the ray's parameter. `highest` may be infinite.
struct DistanceRange {
  double lowest;
  double highest;
};

/// The range in which the exact hit lies, if the kernel found one at `t`. `direction` is the view vector, `surface` has
/// the numbers that the datapath holds. On a ray that runs forward `lowest` is no less than where the surface's box in
/// the hierarchy begins, so that a box beyond some t holds no surface whose range reaches up to it.
DistanceRange distance_range(const SphereSurface<double>& surface, const Vector<double>& direction, double t,
                             const RoundingUnits& rounding);
DistanceRange distance_range(const PlaneSurface<double>& surface, const Vector<double>& direction, double t,
                             const RoundingUnits& rounding);
DistanceRange distance_range(const TriangleSurface<double>& surface, const Vector<double>& direction, double t,
                             const RoundingUnits& rounding);

}  // namespace pyrasim
