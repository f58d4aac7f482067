// SPDX-License-Identifier: Apache-2.0
// What a number format rounds: the units in which errors of the kernels are bounded.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "numeric/number_range.h"

namespace pyrasim {

/// A product, quotient, root or conversion x errs by `relative` |x| + `absolute`, a sum by `relative` |x|.
struct RoundingUnits {
  double relative = 0;  ///< 2^-P; 0 in fixed point
  double absolute = 0;  ///< half of the smallest number
  double place = 0;     ///< the largest of the observer's coordinates in the world, in the prepared scene's unit

  /// By how much a coordinate of the prepared scene, before it is rounded to the format, may lie from what the scene
  /// says; none of the point's coordinates is larger than `size`. The scene's decimal numbers were rounded to double,
  /// 2^-53 of what is at most place + size; the way from the observer to the point was, and three products and their
  /// sum; and the observer's axes are at right angles and of length 1 to a few roundings.
  double written(double size) const { return 0x1p-53 * (18 * size + 4 * place); }
};

inline RoundingUnits rounding_units_of(const NumberFormat& format) {
  RoundingUnits rounding;
  if (format.kind != NumberKind::fixed) rounding.relative = std::ldexp(1.0, -format.significand_bits);
  const double half = std::ldexp(0.5, -finest_fraction_bits(format));
  rounding.absolute = std::max(half, std::numeric_limits<double>::denorm_min());  // double itself cannot hold its own
  return rounding;
}

}  // namespace pyrasim
