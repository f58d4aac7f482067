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
#include "numeric/fix_format.h"
#include "numeric/fix_rounding.h"

namespace pyrasim {

/// A fixed-point number of the format that is set on this thread: W bits in all, the sign included, F of them after
/// the binary point: sc_fixed<W, W - F, R, O>. Values lie between -2^(W-1-F) and 2^(W-1-F) - 2^-F. Counts
/// arithmetic_events.
template <Rounding R, Overflow O>
class BasicFix {
 public:
  using Format = FixFormat;
  /// The format set on this thread, in all modes: FormatScope.
  static Format& format() { return fix_format; }

  constexpr BasicFix() = default;
  /// Rounded as R says. Infinities become the largest and smallest value in every overflow mode, NaN becomes 0.
  template <std::floating_point Number>
  explicit BasicFix(Number x) : raw_(from_double(static_cast<double>(x))) {
    static_assert(std::is_same_v<Number, double> || std::is_same_v<Number, float>);
  }
  template <std::integral Number>
  explicit BasicFix(Number n) : raw_(n == 0 ? 0 : settle(static_cast<Int128>(n) << fix_format.fraction_bits())) {}

  /// The value raw * 2^-F; raw is one that the format has.
  static constexpr BasicFix from_raw(std::int64_t raw) {
    BasicFix result;
    result.raw_ = raw;
    return result;
  }
  constexpr std::int64_t raw() const { return raw_; }

  /// The nearest double: the value itself while it has 53 significant bits or less.
  explicit operator double() const { return static_cast<double>(raw_) * fix_format.resolution(); }
  explicit operator float() const { return static_cast<float>(raw_) * static_cast<float>(fix_format.resolution()); }

  friend BasicFix operator+(BasicFix a, BasicFix b) {
    std::int64_t sum{};
    if (__builtin_add_overflow(a.raw_, b.raw_, &sum)) [[unlikely]]
      return from_raw(settle(Int128{a.raw_} + b.raw_));
    return from_raw(settle(sum));
  }
  friend BasicFix operator-(BasicFix a, BasicFix b) {
    std::int64_t difference{};
    if (__builtin_sub_overflow(a.raw_, b.raw_, &difference)) [[unlikely]]
      return from_raw(settle(Int128{a.raw_} - b.raw_));
    return from_raw(settle(difference));
  }
  friend BasicFix operator*(BasicFix a, BasicFix b) {
    return quantise(scaled_down(Int128{a.raw_} * b.raw_, fix_format.fraction_bits()));
  }
  /// By zero: the largest or smallest value by the numerator's sign, and 0 / 0 = 0, in every overflow mode.
  friend BasicFix operator/(BasicFix a, BasicFix b) {
    if (b.raw_ == 0) [[unlikely]]
      return divide_by_zero(a);
    return quantise(quotient(shifted_left(a.raw_, fix_format.fraction_bits()), b.raw_));
  }
  /// 0 for negative numbers, which counts as invalid.
  friend BasicFix sqrt(BasicFix x) {
    if (x.raw_ < 0) {
      ++arithmetic_events.invalid;
      return BasicFix();
    }
    return quantise(square_root(static_cast<UInt128>(shifted_left(x.raw_, fix_format.fraction_bits()))));
  }

  BasicFix operator-() const { return BasicFix() - *this; }
  constexpr BasicFix operator+() const { return *this; }
  BasicFix& operator+=(BasicFix b) { return *this = *this + b; }
  BasicFix& operator-=(BasicFix b) { return *this = *this - b; }
  BasicFix& operator*=(BasicFix b) { return *this = *this * b; }
  BasicFix& operator/=(BasicFix b) { return *this = *this / b; }

  friend constexpr bool operator==(BasicFix, BasicFix) = default;
  friend constexpr std::strong_ordering operator<=>(BasicFix a, BasicFix b) { return a.raw_ <=> b.raw_; }

  friend BasicFix abs(BasicFix x) { return x.raw_ < 0 ? -x : x; }
  friend BasicFix copysign(BasicFix size, BasicFix sign) { return (size.raw_ < 0) == (sign.raw_ < 0) ? size : -size; }
  friend constexpr bool signbit(BasicFix x) { return x.raw_ < 0; }
  friend constexpr bool isfinite(BasicFix) { return true; }
  friend constexpr bool isnan(BasicFix) { return false; }

 private:
  static BasicFix quantise(const Unrounded& x) {
    const Int128 n = rounded<R>(x);
    if (!fix_format.contains(n, O)) [[unlikely]]
      return from_raw(overflowed(n));
    if (!x.exact()) {
      ++arithmetic_events.inexact;
      if (n == 0) ++arithmetic_events.underflows;
    }
    return from_raw(static_cast<std::int64_t>(n));
  }

  /// Into the range.
  template <class Integer>
  static std::int64_t settle(Integer n) {
    if (fix_format.contains(n, O)) [[likely]]
      return static_cast<std::int64_t>(n);
    return overflowed(n);
  }

  [[gnu::cold]] static std::int64_t overflowed(Int128 n) {
    count_saturation();
    return fix_format.overflowed(n, O);
  }

  static void count_saturation() {
    ++arithmetic_events.saturations;
    ++arithmetic_events.inexact;
  }

  static BasicFix divide_by_zero(BasicFix numerator) {
    ++arithmetic_events.divisions_by_zero;
    if (numerator.raw_ == 0) return BasicFix();
    return from_raw(numerator.raw_ < 0 ? fix_format.smallest(O) : fix_format.largest());
  }

  static std::int64_t from_double(double x);

  std::int64_t raw_ = 0;
};

/// A double is an integer of 53 bits times a power of two.
template <Rounding R, Overflow O>
std::int64_t BasicFix<R, O>::from_double(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const bool negative = bits >> 63U != 0;
  const int biased = static_cast<int>(bits >> 52U) & 0x7ff;
  const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52U) - 1);
  if (biased == 0x7ff) {
    if (fraction != 0) {
      ++arithmetic_events.invalid;
      return 0;
    }
    count_saturation();
    return negative ? fix_format.smallest(O) : fix_format.largest();
  }
  const auto size = static_cast<Int128>(biased == 0 ? fraction : fraction | (std::uint64_t{1} << 52U));
  const Int128 significand = negative ? -size : size;
  const int shift = (biased == 0 ? 1 : biased) - 1075 + fix_format.fraction_bits();  // to units of the last place
  // Below -60 all 53 bits lie under a quarter of the last place; above 70 all lie beyond the range, and 2^W divides it.
  if (shift <= 0) return quantise(scaled_down(significand, shift < -60 ? 60 : -shift)).raw_;
  return settle(significand << (shift > 70 ? 70 : shift));
}

/// As a datapath's.
using Fix = BasicFix<Rounding::SC_RND_CONV, Overflow::SC_SAT>;

}  // namespace pyrasim

/// What depends on the format is that of the format set on this thread, and no constant.
template <pyrasim::Rounding R, pyrasim::Overflow O>
class std::numeric_limits<pyrasim::BasicFix<R, O>> {
  using Number = pyrasim::BasicFix<R, O>;

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
  static constexpr Number min() { return Number::from_raw(1); }  ///< the smallest positive value
  static Number max() { return Number::from_raw(pyrasim::fix_format.largest()); }
  static Number lowest() { return Number::from_raw(pyrasim::fix_format.smallest(O)); }
  static constexpr Number epsilon() { return Number::from_raw(1); }  ///< 2^-F: the spacing everywhere
  static constexpr Number denorm_min() { return Number::from_raw(1); }
  static Number infinity() { return max(); }  ///< no infinity: what lies behind all numbers is the largest
};
