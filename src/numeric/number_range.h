// SPDX-License-Identifier: Apache-2.0
// How large and how small the numbers of a format can be.
#pragma once

#include "numeric/number_format.h"

namespace pyrasim {

/// The smallest n such that all numbers of the format are below 2^n in magnitude, but for rounding up to it.
inline int integer_bits(const NumberFormat& format) {
  if (format.kind == NumberKind::fixed) return format.bits - 1 - format.fraction_bits;
  return 1 << (static_cast<unsigned>(format.exponent_bits) - 1);
}

/// Numbers near 0 are the multiples of 2^-n.
inline int finest_fraction_bits(const NumberFormat& format) {
  if (format.kind == NumberKind::fixed) return format.fraction_bits;
  return integer_bits(format) - 2 + format.significand_bits - 1;
}

}  // namespace pyrasim
