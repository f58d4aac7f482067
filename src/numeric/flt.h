// SPDX-License-Identifier: Apache-2.0
// Binary floating point with 2 to 11 bits of exponent and 2 to 25 of significand, bit for bit as IEEE 754 has it.
//
// A value is held as a double. An operation is done in double and its result rounded a second time, to the format. That
// gives the nearest value, as one rounding would. The two can differ only if the exact result r is not the midpoint m
// of two neighbours in the format, but the double nearest to r is m (midpoints are doubles, and rounding is monotone).
// - Sums: r is a multiple of the smaller operand's unit. Where that lets r fit into 53 bits, the double is exact; else
//   the operands lie more than 2^27 apart, r is nearer than a quarter of a unit to the larger, and no midpoint is near.
// - Products have 2P <= 50 bits: the double is exact.
// - Quotients a / b: a - m b is a multiple of a unit of a, more than 2^-P a, or of a unit of m b, which has 2P + 1 bits
//   at most. So r is m, or further from it than 2^-(2P+1) m >= 2^-51 m, and double's error is at most 2^-53 m.
// - Square roots: likewise |r - m| = |x - m^2| / (r + m) > 2^-(2P+2) m >= 2^-52 m.
// (Figueroa, When is double rounding innocuous?, 1995, has it for P bits with 53 >= 2P + 2.) All of it holds for
// subnormal results, whose m has fewer bits; their sums are exact. It asks for an r in double's normal range, which
// holds at every midpoint while E <= 10; with E = 11 tiny products and quotients are computed 2^512 times as large.
// A multiply-add fused in double would not be exact, and there is none.
#pragma once

#include <algorithm>
#include <cmath>
#include <compare>
#include <concepts>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "numeric/arithmetic_events.h"
#include "numeric/flt_edge.h"
#include "numeric/flt_rounding.h"

namespace pyrasim {

/// A floating-point number; `E` bits of exponent, `P` of significand with the hidden one: 1 + E + P - 1 bits in all.
/// Rounds to nearest, ties to even; subnormal numbers, infinities and NaN as IEEE 754. Counts arithmetic_events.
template <int E, int P>
class Flt {
  static_assert(2 <= E && E <= 11, "the exponent must fit into that of double");
  static_assert(2 <= P && P <= 25, "2P + 2 <= 53: beyond that an operation in double would round twice");
  using Rounding = FltRounding<E, P>;
  using Edge = FltEdge<E, P>;

 public:
  static constexpr int exponent_bits = E;
  static constexpr int significand_bits = P;

  constexpr Flt() = default;
  /// The nearest value.
  template <std::floating_point Number>
  constexpr explicit Flt(Number x) : value_(Edge::convert(x)) {
    static_assert(std::is_same_v<Number, double> || std::is_same_v<Number, float>);
  }
  template <std::integral Number>
  constexpr explicit Flt(Number n) : value_(Edge::convert_integer(n)) {}

  /// A double that is known to be a value of the format.
  static constexpr Flt from_exact(double value) {
    Flt result;
    result.value_ = value;
    return result;
  }

  constexpr explicit operator double() const { return value_; }
  constexpr explicit operator float() const { return static_cast<float>(value_); }

  friend Flt operator+(Flt a, Flt b) { return add(a.value_, b.value_); }
  friend Flt operator-(Flt a, Flt b) { return add(a.value_, -b.value_); }
  friend Flt operator*(Flt a, Flt b) {
    const double product = a.value_ * b.value_;
    if (!Rounding::is_normal(product)) [[unlikely]]
      return from_exact(Edge::multiply(a.value_, b.value_));
    const double rounded = Rounding::round_normal(product);
    arithmetic_events.inexact += rounded != product ? 1 : 0;
    return from_exact(rounded);
  }
  friend Flt operator/(Flt a, Flt b) {
    const double quotient = a.value_ / b.value_;
    if (!Rounding::is_normal(quotient)) [[unlikely]]
      return from_exact(Edge::divide(a.value_, b.value_));
    const double rounded = Rounding::round_normal(quotient);
    arithmetic_events.inexact += Edge::is_product(a.value_, rounded, b.value_) ? 0 : 1;
    return from_exact(rounded);
  }
  friend Flt sqrt(Flt x) {
    const double root = std::sqrt(x.value_);
    if (!Rounding::is_normal(root)) [[unlikely]]
      return from_exact(Edge::square_root(x.value_));
    const double rounded = Rounding::round_normal(root);
    arithmetic_events.inexact += Edge::is_product(x.value_, rounded, rounded) ? 0 : 1;
    return from_exact(rounded);
  }

  constexpr Flt operator-() const { return from_exact(-value_); }
  constexpr Flt operator+() const { return *this; }
  Flt& operator+=(Flt b) { return *this = *this + b; }
  Flt& operator-=(Flt b) { return *this = *this - b; }
  Flt& operator*=(Flt b) { return *this = *this * b; }
  Flt& operator/=(Flt b) { return *this = *this / b; }

  friend constexpr bool operator==(Flt a, Flt b) { return a.value_ == b.value_; }
  friend constexpr std::partial_ordering operator<=>(Flt a, Flt b) { return a.value_ <=> b.value_; }

  friend constexpr Flt abs(Flt x) { return from_exact(magnitude(x.value_)); }
  friend Flt copysign(Flt size, Flt sign) { return from_exact(std::copysign(size.value_, sign.value_)); }
  friend bool signbit(Flt x) { return std::signbit(x.value_); }
  friend bool isfinite(Flt x) { return std::isfinite(x.value_); }
  friend bool isnan(Flt x) { return std::isnan(x.value_); }

 private:
  static Flt add(double a, double b) {
    const double sum = a + b;
    if (!Rounding::is_normal(sum)) [[unlikely]]
      return from_exact(Edge::add(a, b));
    const double rounded = Rounding::round_normal(sum);
    // The difference to the larger operand is exact, so it equals the other one only if the sum is.
    arithmetic_events.inexact += ((rounded - a == b) & (rounded - b == a)) ? 0 : 1;
    return from_exact(rounded);
  }

  double value_ = 0;
};

using Fp16 = Flt<5, 11>;  ///< IEEE 754 binary16
using Bf16 = Flt<8, 8>;   ///< bfloat16
using Tf32 = Flt<8, 11>;  ///< TensorFloat-32: 19 bits
using Fp24 = Flt<7, 17>;  ///< 24 bits

}  // namespace pyrasim

template <int E, int P>
class std::numeric_limits<pyrasim::Flt<E, P>> {
  using Number = pyrasim::Flt<E, P>;
  using Rounding = pyrasim::FltRounding<E, P>;

 public:
  static constexpr bool is_specialized = true;
  static constexpr bool is_signed = true;
  static constexpr bool is_integer = false;
  static constexpr bool is_exact = false;
  static constexpr bool is_iec559 = true;
  static constexpr bool is_bounded = true;
  static constexpr bool has_infinity = true;
  static constexpr bool has_quiet_NaN = true;  // NOLINT(readability-identifier-naming): std
  static constexpr std::float_round_style round_style = std::round_to_nearest;
  static constexpr int radix = 2;
  static constexpr int digits = P;
  static constexpr int min_exponent = Rounding::smallest_exponent + 1;
  static constexpr int max_exponent = Rounding::largest_exponent + 1;
  static constexpr Number min() { return Number::from_exact(Rounding::smallest_normal); }
  static constexpr Number max() { return Number::from_exact(Rounding::largest); }
  static constexpr Number lowest() { return Number::from_exact(-Rounding::largest); }
  static constexpr Number epsilon() { return Number(pyrasim::power_of_two(1 - P)); }
  static constexpr Number denorm_min() { return Number::from_exact(Rounding::spacing); }
  static constexpr Number infinity() { return Number::from_exact(std::numeric_limits<double>::infinity()); }
  // NOLINTNEXTLINE(readability-identifier-naming): std
  static constexpr Number quiet_NaN() { return Number::from_exact(std::numeric_limits<double>::quiet_NaN()); }
};
