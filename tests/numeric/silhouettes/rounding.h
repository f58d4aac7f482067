// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "numeric/number_format.h"

namespace pyrasim::silhouettes {

/// How much a number format rounds. A product, quotient, root or conversion x errs by `relative` |x| + `absolute`, a
/// sum by `relative` |x|; the slopes of a ray likewise before anything is computed from them.
struct Rounding {
  double relative = 0;        ///< 2^-P; 0 in fixed point
  double absolute = 0;        ///< half of the smallest number
  double slope_relative = 0;  ///< of slopes as they enter the datapath
  double slope_absolute = 0;
  int exponent = 0;  ///< a length of the datapath is one of the exact scene times 2^exponent

  /// `absolute` of a result that is a length to the power of `dimension`, in the exact scene's units.
  double lost(int dimension) const { return std::ldexp(absolute, -dimension * exponent); }

  /// The rounding of a format with log2(1 / factor) more bits, of the same scale.
  Rounding times(double factor) const {
    return {relative * factor, absolute * factor, slope_relative * factor, slope_absolute * factor, exponent};
  }
};

/// How the slopes of a ray, which is exact, enter the datapath: rounded to the format.
enum class Slopes : bool {
  rounded,  ///< once
  computed  ///< by ViewVectors, after two roundings in double
};

inline Rounding rounding_of(const NumberFormat& format, int exponent, Slopes slopes) {
  constexpr double in_double = 0x1p-53;
  Rounding rounding{.exponent = exponent};
  if (format.kind == NumberKind::fixed) {
    rounding.absolute = std::ldexp(0.5, -format.fraction_bits);
  } else {
    const int smallest_exponent = 2 - (1 << (static_cast<unsigned>(format.exponent_bits) - 1));
    rounding.relative = std::ldexp(1.0, -format.significand_bits);
    rounding.absolute = std::ldexp(0.5, smallest_exponent + 1 - format.significand_bits);
  }
  if (format != NumberFormat()) {
    rounding.slope_relative = rounding.relative;
    rounding.slope_absolute = rounding.absolute;
  }
  if (slopes == Slopes::computed) rounding.slope_relative += 2 * in_double;
  return rounding;
}

}  // namespace pyrasim::silhouettes
