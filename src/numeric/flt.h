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

#include <cmath>
#include <compare>
#include <concepts>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>

#include "numeric/arithmetic_events.h"
#include "numeric/flt_edge.h"
#include "numeric/flt_format.h"

namespace pyrasim {

/// A floating-point number of the format that is set on this thread: E bits of exponent, P of significand with the
/// hidden one. Rounds to nearest, ties to even; subnormal numbers, infinities and NaN as IEEE 754. Counts
/// arithmetic_events.
class Flt {
 public:
  using Format = FltFormat;
  /// The format set on this thread: FormatScope.
  static Format& format() { return flt_format; }

  constexpr Flt() = default;
  /// The nearest value.
  template <std::floating_point Number>
  explicit Flt(Number x) : value_(converted(x)) {
    static_assert(std::is_same_v<Number, double> || std::is_same_v<Number, float>);
  }
  template <std::integral Number>
  explicit Flt(Number n) : value_(converted_integer(n)) {}

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
    if (!flt_format.is_normal(product)) [[unlikely]]
      return from_exact(flt_edge::multiply(flt_format, a.value_, b.value_));
    const double rounded = flt_format.round_normal(product);
    arithmetic_events.inexact += rounded != product ? 1 : 0;
    return from_exact(rounded);
  }
  friend Flt operator/(Flt a, Flt b) {
    const double quotient = a.value_ / b.value_;
    if (!flt_format.is_normal(quotient)) [[unlikely]]
      return from_exact(flt_edge::divide(flt_format, a.value_, b.value_));
    const double rounded = flt_format.round_normal(quotient);
    arithmetic_events.inexact += is_product(a.value_, rounded, b.value_) ? 0 : 1;
    return from_exact(rounded);
  }
  friend Flt sqrt(Flt x) {
    const double root = std::sqrt(x.value_);
    if (!flt_format.is_normal(root)) [[unlikely]]
      return from_exact(flt_edge::square_root(flt_format, x.value_));
    const double rounded = flt_format.round_normal(root);
    arithmetic_events.inexact += is_product(x.value_, rounded, rounded) ? 0 : 1;
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
  static double converted(double x) {
    if (!flt_format.is_normal(x)) [[unlikely]]
      return flt_edge::convert(flt_format, x);
    const double rounded = flt_format.round_normal(x);
    arithmetic_events.inexact += rounded != x ? 1 : 0;
    return rounded;
  }

  /// Every format has 0 to 3. Above 2^53 a long integer would be rounded twice: its last eleven bits become one that
  /// tells whether any was set. What remains has 42 bits or more, enough for the format's rounding.
  template <std::integral Integer>
  static double converted_integer(Integer n) {
    const bool negative = std::cmp_less(n, 0);
    auto bits = static_cast<std::uint64_t>(n);
    if (negative) bits = -bits;
    if (bits <= 3) return static_cast<double>(n);
    if (bits >> 53U != 0) {
      bits = (bits & ~std::uint64_t{0x7ff}) | (static_cast<std::uint64_t>((bits & 0x7ffU) != 0) << 11U);
    }
    const auto exact = static_cast<double>(bits);
    return converted(negative ? -exact : exact);
  }

  static Flt add(double a, double b) {
    const double sum = a + b;
    if (!flt_format.is_normal(sum)) [[unlikely]]
      return from_exact(flt_edge::add(flt_format, a, b));
    const double rounded = flt_format.round_normal(sum);
    // The difference to the larger operand is exact, so it equals the other one only if the sum is.
    arithmetic_events.inexact += ((rounded - a == b) & (rounded - b == a)) ? 0 : 1;
    return from_exact(rounded);
  }

  /// Whether product = a * b exactly, where it holds nearly. Up to 10 bits of exponent double's product is exact.
  static bool is_product(double product, double a, double b) {
    if (flt_format.exponent_bits() > 10) [[unlikely]]
      return flt_edge::is_product(product, a, b);
    return a * b == product;
  }

  double value_ = 0;
};

}  // namespace pyrasim

/// What depends on the format is that of the format set on this thread, and no constant.
template <>
class std::numeric_limits<pyrasim::Flt> {
  using Number = pyrasim::Flt;

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
  static Number min() { return Number::from_exact(pyrasim::flt_format.smallest_normal()); }
  static Number max() { return Number::from_exact(pyrasim::flt_format.largest()); }
  static Number lowest() { return Number::from_exact(-pyrasim::flt_format.largest()); }
  static Number epsilon() {
    return Number::from_exact(pyrasim::power_of_two(1 - pyrasim::flt_format.significand_bits()));
  }
  static Number denorm_min() { return Number::from_exact(pyrasim::flt_format.spacing()); }
  static constexpr Number infinity() { return Number::from_exact(std::numeric_limits<double>::infinity()); }
  // NOLINTNEXTLINE(readability-identifier-naming): std
  static constexpr Number quiet_NaN() { return Number::from_exact(std::numeric_limits<double>::quiet_NaN()); }
};
