// SPDX-License-Identifier: Apache-2.0
// Operations of Flt at the edges of its range: overflow, subnormal results, zero, infinities and NaN. Rare, hence
// apart.
#pragma once

#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>

#include "numeric/arithmetic_events.h"
#include "numeric/flt_rounding.h"

namespace pyrasim {

/// All operands and results are values of the format, held as doubles; convert() excepted.
template <int E, int P>
struct FltEdge {
  using Rounding = FltRounding<E, P>;

  static constexpr double convert(double x) {
    if (Rounding::is_normal(x)) {
      const double rounded = Rounding::round_normal(x);
      if (!std::is_constant_evaluated()) arithmetic_events.inexact += rounded != x ? 1 : 0;
      return rounded;
    }
    const double size = magnitude(x);
    if (!(size > 0 && size <= std::numeric_limits<double>::max())) return x;  // 0, infinity or NaN
    if (size >= Rounding::overflow_threshold) return overflow(x < 0);
    return tiny(x * Rounding::lift, Rounding::round_tiny(x * Rounding::lift));
  }

  /// Above 2^53 a long integer would be rounded twice: its last eleven bits become one that tells whether any was set.
  /// What remains has 42 bits or more, enough for the format's rounding.
  template <std::integral Integer>
  static constexpr double convert_integer(Integer n) {
    using Bits = std::uint64_t;
    const bool negative = std::cmp_less(n, 0);
    auto bits = static_cast<Bits>(n);
    if (negative) bits = -bits;
    if (bits >> 53U != 0) bits = (bits & ~Bits{0x7ff}) | (static_cast<Bits>((bits & 0x7ffU) != 0) << 11U);
    const auto exact = static_cast<double>(bits);
    return convert(negative ? -exact : exact);
  }

  /// Sums below the normal range are exact: both operands are multiples of the spacing there.
  [[gnu::cold]] static double add(double a, double b) {
    const double sum = a + b;
    if (!std::isfinite(a) || !std::isfinite(b)) return special(sum, a, b);
    return magnitude(sum) >= Rounding::overflow_threshold ? overflow(sum < 0) : sum;
  }

  [[gnu::cold]] static double multiply(double a, double b) {
    const double product = a * b;
    if (!std::isfinite(a) || !std::isfinite(b)) return special(product, a, b);
    if (magnitude(product) >= Rounding::overflow_threshold) return overflow(std::signbit(product));
    if (a == 0 || b == 0) return product;
    if (magnitude(a) > magnitude(b)) std::swap(a, b);
    const double lifted = (a * Rounding::lift) * b;  // exact, or so small that the result is 0 anyway
    return tiny(lifted, Rounding::round_tiny(lifted), lifted == 0);
  }

  [[gnu::cold]] static double divide(double a, double b) {
    const double quotient = a / b;
    if (std::isfinite(a) && b == 0) {
      ++arithmetic_events.divisions_by_zero;
      return quotient;
    }
    if (!std::isfinite(a) || !std::isfinite(b)) return special(quotient, a, b);
    if (magnitude(quotient) >= Rounding::overflow_threshold) return overflow(std::signbit(quotient));
    const double lifted_dividend = a * Rounding::lift;  // the quotient is tiny, so that |a| < 8 where it matters
    const double lifted = lifted_dividend / b;
    const double rounded = Rounding::round_tiny(lifted);
    return tiny(lifted, rounded, rounded * b != lifted_dividend);
  }

  [[gnu::cold]] static double square_root(double x) {
    const double root = std::sqrt(x);
    if (!(x > 0) || !std::isfinite(x)) return special(root, x, x);
    const double rounded = Rounding::round_tiny(root);  // only where E is small for P: lift is 1
    return tiny(root, rounded, rounded * rounded != x);
  }

  /// Whether product = a * b exactly, where it holds nearly. With E <= 10 double's product is exact. With E = 11 that
  /// of small numbers need not be: then both sides are taken 2^128 times as large.
  static bool is_product(double product, double a, double b) {
    if constexpr (E < 11) {
      return a * b == product;
    } else {
      if (magnitude(product) >= 1) return a * b == product;
      if (magnitude(a) > magnitude(b)) std::swap(a, b);
      return (a * power_of_two(128)) * b == product * power_of_two(128);
    }
  }

 private:
  static constexpr double overflow(bool negative) {
    if (!std::is_constant_evaluated()) {
      ++arithmetic_events.saturations;
      ++arithmetic_events.inexact;
    }
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return negative ? -infinity : infinity;
  }

  /// A result below the normal range; both arguments are `lift` times as large as what they stand for. `inexact`:
  /// that the result is not exact although the two are equal.
  static constexpr double tiny(double lifted, double rounded, bool inexact = false) {
    if ((inexact || rounded != lifted) && !std::is_constant_evaluated()) {
      ++arithmetic_events.underflows;
      ++arithmetic_events.inexact;
    }
    return rounded / Rounding::lift;
  }

  /// The result with an operand that is infinite or NaN, or of the root of a negative number.
  static double special(double result, double a, double b) {
    if (std::isnan(result) && !std::isnan(a) && !std::isnan(b)) ++arithmetic_events.invalid;
    return result;
  }
};

}  // namespace pyrasim
