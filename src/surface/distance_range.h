// SPDX-License-Identifier: Apache-2.0
// Where the exact hit lies, given the one that a datapath computed: forward error bounds of the surfaces' kernels,
// operation by operation, in each surface's .cpp. Worked out in double beside the datapath, for every format.
//
// Exact is what the scene says, decimal numbers as written, along the ray as it enters the kernels: the view vector's
// own rounding moves all surfaces alike.
#pragma once

#include <algorithm>

#include "surface/rounding_units.h"

namespace pyrasim {

/// A range of the ray's parameter. `highest` may be infinite.
///
/// Each surface has distance_range(surface, direction, t, rounding): the range in which the exact hit lies, if the
/// kernel found one at `t`. `direction` is the view vector, `surface` has the numbers that the datapath holds. On a ray
/// that runs forward `lowest` is no less than where the surface's box in the hierarchy begins, so that a box beyond
/// some t holds no surface whose range reaches up to it.
///
/// And it has relative_error(surface, rounding), what can be known before there is a ray: coarser, and free, and most
/// hits are told apart by it. |t - exact t| <= the result * t for every ray on which the kernel finds a hit, and
/// distance_range() lies within; infinity where that is not less than 2^-8. `surface` is as prepared, not yet rounded.
struct DistanceRange {
  double lowest;
  double highest;
};

/// Where the later, or the earlier, of two values of t lies.
inline DistanceRange later(const DistanceRange& a, const DistanceRange& b) {
  return {std::max(a.lowest, b.lowest), std::max(a.highest, b.highest)};
}
inline DistanceRange earlier(const DistanceRange& a, const DistanceRange& b) {
  return {std::min(a.lowest, b.lowest), std::min(a.highest, b.highest)};
}

}  // namespace pyrasim
