// SPDX-License-Identifier: Apache-2.0
// Fixed point: two's complement with a binary point, bit for bit as SystemC's sc_fixed, at integer speed.
//
// Every result is the exact real result of its operands quantised once, quotients and square roots included.
#pragma once

#include <bit>
#include <compare>
#include <concepts>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "numeric/arithmetic_events.h"
#include "numeric/fix_rounding.h"

namespace pyrasim {

/// `W` bits in all, the sign included, `F` of them after the binary point: sc_fixed<W, W - F, R, O>. Values lie between
/// -2^(W-1-F) and 2^(W-1-F) - 2^-F. Counts arithmetic_events.
template <int W, int F, Rounding R = Rounding::SC_RND_CONV, Overflow O = Overflow::SC_SAT>
class Fix {
  static_assert(2 <= W && W <= 64 && 0 <= F && F < W);
  using Range = FixRange<W, O>;
  using Product = std::conditional_t<W <= 32, std::int64_t, Int128>;
  using Sum = std::conditional_t<W <= 63, std::int64_t, Int128>;

 public:
  static constexpr int width = W;
  static constexpr int fraction_bits = F;

  constexpr Fix() = default;
  /// Rounded as R says. Infinities become the largest and smallest value in every overflow mode, NaN becomes 0.
  template <std::floating_point Number>
  constexpr explicit Fix(Number x) : raw_(from_double(static_cast<double>(x))) {
    static_assert(std::is_same_v<Number, double> || std::is_same_v<Number, float>);
  }
  template <std::integral Number>
  constexpr explicit Fix(Number n) : raw_(settle(static_cast<Int128>(n) << F)) {}

  /// The value raw * 2^-F; raw is one that the format has.
  static constexpr Fix from_raw(std::int64_t raw) {
    Fix result;
    result.raw_ = raw;
    return result;
  }
  constexpr std::int64_t raw() const { return raw_; }

  /// The nearest double: the value itself while it has 53 significant bits or less.
  constexpr explicit operator double() const { return static_cast<double>(raw_) * resolution; }
  constexpr explicit operator float() const { return static_cast<float>(raw_) * static_cast<float>(resolution); }

  friend constexpr Fix operator+(Fix a, Fix b) { return from_raw(settle(Sum{a.raw_} + b.raw_)); }
  friend constexpr Fix operator-(Fix a, Fix b) { return from_raw(settle(Sum{a.raw_} - b.raw_)); }
  friend constexpr Fix operator*(Fix a, Fix b) { return quantise(scaled_down(Product{a.raw_} * b.raw_, F)); }
  /// By zero: the largest or smallest value by the numerator's sign, and 0 / 0 = 0, in every overflow mode.
  friend constexpr Fix operator/(Fix a, Fix b) {
    if (b.raw_ == 0) [[unlikely]]
      return divide_by_zero(a);
    return quantise(quotient(static_cast<Int128>(a.raw_) << F, b.raw_));
  }
  /// 0 for negative numbers, which counts as invalid.
  friend constexpr Fix sqrt(Fix x) {
    if (x.raw_ < 0) {
      if (!std::is_constant_evaluated()) ++arithmetic_events.invalid;
      return Fix();
    }
    return quantise(square_root(static_cast<UInt128>(x.raw_) << F));
  }

  constexpr Fix operator-() const { return from_raw(settle(-Sum{raw_})); }
  constexpr Fix operator+() const { return *this; }
  constexpr Fix& operator+=(Fix b) { return *this = *this + b; }
  constexpr Fix& operator-=(Fix b) { return *this = *this - b; }
  constexpr Fix& operator*=(Fix b) { return *this = *this * b; }
  constexpr Fix& operator/=(Fix b) { return *this = *this / b; }

  friend constexpr bool operator==(Fix, Fix) = default;
  friend constexpr std::strong_ordering operator<=>(Fix a, Fix b) { return a.raw_ <=> b.raw_; }

  friend constexpr Fix abs(Fix x) { return x.raw_ < 0 ? -x : x; }
  friend constexpr Fix copysign(Fix size, Fix sign) { return (size.raw_ < 0) == (sign.raw_ < 0) ? size : -size; }
  friend constexpr bool signbit(Fix x) { return x.raw_ < 0; }
  friend constexpr bool isfinite(Fix) { return true; }
  friend constexpr bool isnan(Fix) { return false; }

 private:
  static constexpr double resolution = 1.0 / static_cast<double>(std::uint64_t{1} << static_cast<unsigned>(F));

  static constexpr Fix quantise(const auto& x) {
    const auto n = rounded<R>(x);
    if (Range::contains(n) && !x.exact() && !std::is_constant_evaluated()) {
      ++arithmetic_events.inexact;
      if (n == 0) ++arithmetic_events.underflows;
    }
    return from_raw(settle(n));
  }

  /// Into the range.
  static constexpr std::int64_t settle(auto n) {
    if (Range::contains(n)) [[likely]]
      return static_cast<std::int64_t>(n);
    if (!std::is_constant_evaluated()) count_saturation();
    return Range::overflowed(n);
  }

  static void count_saturation() {
    ++arithmetic_events.saturations;
    ++arithmetic_events.inexact;
  }

  static constexpr Fix divide_by_zero(Fix numerator) {
    if (!std::is_constant_evaluated()) ++arithmetic_events.divisions_by_zero;
    if (numerator.raw_ == 0) return Fix();
    return from_raw(numerator.raw_ < 0 ? Range::smallest : Range::largest);
  }

  static constexpr std::int64_t from_double(double x);

  std::int64_t raw_ = 0;
};

/// A double is an integer of 53 bits times a power of two.
template <int W, int F, Rounding R, Overflow O>
constexpr std::int64_t Fix<W, F, R, O>::from_double(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const bool negative = bits >> 63U != 0;
  const int biased = static_cast<int>(bits >> 52U) & 0x7ff;
  const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52U) - 1);
  if (biased == 0x7ff) {
    const bool nan = fraction != 0;
    if (!std::is_constant_evaluated()) {
      if (nan)
        ++arithmetic_events.invalid;
      else
        count_saturation();
    }
    if (nan) return 0;
    return negative ? Range::smallest : Range::largest;
  }
  const auto size = static_cast<Int128>(biased == 0 ? fraction : fraction | (std::uint64_t{1} << 52U));
  const Int128 significand = negative ? -size : size;
  const int shift = (biased == 0 ? 1 : biased) - 1075 + F;  // to units of the last place
  // Below -60 all 53 bits lie under a quarter of the last place; above 70 all lie beyond the range, and 2^W divides it.
  if (shift <= 0) return quantise(scaled_down(significand, shift < -60 ? 60 : -shift)).raw_;
  return settle(significand << (shift > 70 ? 70 : shift));
}

}  // namespace pyrasim

template <int W, int F, pyrasim::Rounding R, pyrasim::Overflow O>
class std::numeric_limits<pyrasim::Fix<W, F, R, O>> {
  using Number = pyrasim::Fix<W, F, R, O>;
  using Range = pyrasim::FixRange<W, O>;

 public:
  static constexpr bool is_specialized = true;
  static constexpr bool is_signed = true;
  static constexpr bool is_integer = false;
  static constexpr bool is_exact = false;
  static constexpr bool is_iec559 = false;
  static constexpr bool is_bounded = true;
  static constexpr bool is_modulo = O == pyrasim::Overflow::SC_WRAP;
  static constexpr bool has_infinity = false;
  static constexpr bool has_quiet_NaN = false;  // NOLINT(readability-identifier-naming): std
  static constexpr int radix = 2;
  static constexpr int digits = W - 1;
  static constexpr Number min() { return Number::from_raw(1); }  ///< the smallest positive value
  static constexpr Number max() { return Number::from_raw(Range::largest); }
  static constexpr Number lowest() { return Number::from_raw(Range::smallest); }
  static constexpr Number epsilon() { return Number::from_raw(1); }  ///< 2^-F: the spacing everywhere
  static constexpr Number denorm_min() { return Number::from_raw(1); }
  static constexpr Number infinity() { return max(); }  ///< no infinity: what lies behind all numbers is the largest
};
