// SPDX-License-Identifier: Apache-2.0
// Fixed point on GMP's integers: exact fractions, rounded by the words of IEEE 1666 and by nothing that Fix shares.
#pragma once

#include <gmpxx.h>

#include <cmath>
#include <cstdint>

#include "numeric/fix_rounding.h"

namespace pyrasim {

/// A nearest or directed integer to `exact`, as the mode says.
inline mpz_class oracle_rounded(const mpq_class& exact, Rounding mode) {
  mpz_class below;
  mpz_fdiv_q(below.get_mpz_t(), exact.get_num_mpz_t(), exact.get_den_mpz_t());
  if (exact.get_den() == 1) return below;
  const mpz_class above = below + 1;
  const mpz_class& towards_zero = sgn(exact) < 0 ? above : below;
  const mpz_class& away = sgn(exact) < 0 ? below : above;
  if (mode == Rounding::SC_TRN) return below;
  if (mode == Rounding::SC_TRN_ZERO) return towards_zero;
  const int side = cmp(mpq_class(exact - below), mpq_class(1, 2));
  if (side != 0) return side < 0 ? below : above;
  if (mode == Rounding::SC_RND) return above;
  if (mode == Rounding::SC_RND_MIN_INF) return below;
  if (mode == Rounding::SC_RND_ZERO) return towards_zero;
  if (mode == Rounding::SC_RND_INF) return away;
  return mpz_even_p(below.get_mpz_t()) != 0 ? below : above;
}

/// An integer of `width` bits, by the overflow mode.
inline mpz_class oracle_limited(const mpz_class& n, int width, Overflow mode) {
  const mpz_class beyond = mpz_class(1) << static_cast<unsigned>(width - 1);
  const mpz_class smallest = mode == Overflow::SC_SAT_SYM ? mpz_class(1 - beyond) : mpz_class(-beyond);
  if (n >= smallest && n < beyond) return n;
  if (mode == Overflow::SC_SAT_ZERO) return 0;
  if (mode != Overflow::SC_WRAP) return n < 0 ? smallest : mpz_class(beyond - 1);
  mpz_class wrapped;
  mpz_fdiv_r(wrapped.get_mpz_t(), mpz_class(n + beyond).get_mpz_t(), mpz_class(2 * beyond).get_mpz_t());
  return wrapped - beyond;
}

/// The square root of `square` >= 0 to an integer. It is never half-way between two, so that a number on the same side
/// of the next half takes its place.
inline mpz_class oracle_root(const mpz_class& square, Rounding mode) {
  const mpz_class floor = sqrt(square);
  const mpz_class rest = square - floor * floor;
  if (rest == 0) return floor;
  const bool above_half = 4 * square > (2 * floor + 1) * (2 * floor + 1);
  return oracle_rounded(mpq_class(4 * floor + (above_half ? 3 : 1), 4), mode);
}

inline mpz_class to_mpz(std::int64_t n) { return mpz_class(static_cast<long>(n)); }

}  // namespace pyrasim
