// SPDX-License-Identifier: Apache-2.0
// Doubles rounded once, to nearest with ties to even, to a narrower binary format.
#pragma once

#include <bit>
#include <cstdint>

#include "numeric/number_format.h"

namespace pyrasim {

/// 2^exponent, for exponents of normal doubles.
constexpr double power_of_two(int exponent) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52U);
}

constexpr double magnitude(double x) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & ~(std::uint64_t{1} << 63U));
}

/// The format of IEEE 754 with so many bits of exponent and of significand, the hidden one included: all that an
/// operation asks of it, worked out beforehand.
class FltFormat {
 public:
  /// None: no number is_normal().
  constexpr FltFormat() = default;
  /// Throws std::logic_error if it is no floating-point format within the limits.
  explicit FltFormat(const NumberFormat& format);

  NumberFormat number_format() const { return NumberFormat::floating(exponent_bits_, significand_bits()); }
  int exponent_bits() const { return exponent_bits_; }
  int significand_bits() const { return static_cast<int>(53 - dropped_); }
  double smallest_normal() const { return std::bit_cast<double>(smallest_normal_); }
  double largest() const { return largest_; }
  /// From here on the nearest value would be 2^(largest exponent + 1): infinity.
  double overflow_threshold() const { return std::bit_cast<double>(smallest_normal_ + normal_); }
  /// The smallest subnormal number, which is also the spacing of all numbers below 2 smallest_normal.
  double spacing() const { return spacing_; }
  /// A power of two that lifts tiny numbers out of double's own subnormal range. Only the widest exponent needs it:
  /// with 10 bits or fewer every product of two numbers is a multiple of 2^-1068 and hence an exact double.
  double lift() const { return lift_; }

  /// Whether x rounds to a normal number because it lies between the smallest and the largest of them.
  bool is_normal(double x) const { return std::bit_cast<std::uint64_t>(magnitude(x)) - smallest_normal_ < normal_; }

  /// x, which is_normal(), to the significand's bits: adds half a unit less one bit, and that bit where the unit is
  /// odd, so that the carry rounds ties to even; then cuts. A carry into the exponent is right as it stands.
  double round_normal(double x) const {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    return std::bit_cast<double>((bits + below_half_ + ((bits >> dropped_) & 1U)) & kept_);
  }

  /// x, |x| <= 2 smallest_normal * lift, to a multiple of spacing * lift. Adding 1.5 * 2^52 spacings leaves no bit for
  /// what lies below the spacing: double's own addition rounds it away, once, ties to even. A zero keeps the sign.
  double round_tiny(double x) const {
    const double rounded = (x + shifter_) - shifter_;
    constexpr std::uint64_t sign = std::uint64_t{1} << 63U;
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(rounded) | (std::bit_cast<std::uint64_t>(x) & sign));
  }

 private:
  std::uint64_t smallest_normal_ = 0;  ///< as bits
  std::uint64_t normal_ = 0;           ///< from there to the overflow threshold
  std::uint64_t dropped_ = 0;          ///< bits of a double's significand
  std::uint64_t below_half_ = 0;       ///< of the unit that is left, by one bit
  std::uint64_t kept_ = 0;             ///< mask of the bits that are left
  int exponent_bits_ = 0;
  double largest_ = 0;
  double spacing_ = 0;
  double lift_ = 1;
  double shifter_ = 0;
};

/// The format in which Flt computes on this thread. Set by FormatScope.
inline constinit thread_local FltFormat flt_format{};

}  // namespace pyrasim
