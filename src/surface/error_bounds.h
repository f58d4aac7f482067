// SPDX-License-Identifier: Apache-2.0
// What the error bounds of several surfaces share. Letters as in docs/numerics.md: u is the format's relative rounding,
// a its absolute one. Terms of second order that are not written out are covered by a factor 1 + 16u.
#pragma once

#include <limits>

#include "numeric/vectors.h"
#include "surface/distance_range.h"
#include "surface/rounding_units.h"

namespace pyrasim {

inline double second_order(const RoundingUnits& rounding) { return 1 + 16 * rounding.relative; }

/// A number, and by how much it may lie from the exact one.
struct Bounded {
  double value;
  double error;
};

/// `range`, but no further than the surface's bounds along x, from `begin` to `end`.
DistanceRange within_bounds(const DistanceRange& range, double begin, double end, const Vector<double>& direction);

/// `error`, a relative one, or infinity. What a coarser bound would tell apart, the finer one has to look at in any
/// case. In fixed point errors are absolute.
double if_of_use(double error, const RoundingUnits& rounding);

}  // namespace pyrasim
