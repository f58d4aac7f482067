// SPDX-License-Identifier: Apache-2.0
// Doubles rounded once, to nearest with ties to even, to a narrower binary format.
#pragma once

#include <bit>
#include <cstdint>

namespace pyrasim {

/// 2^exponent, for exponents of normal doubles.
constexpr double power_of_two(int exponent) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52U);
}

constexpr double magnitude(double x) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & ~(std::uint64_t{1} << 63U));
}

/// The format of IEEE 754 with `E` bits of exponent and `P` bits of significand, the hidden one included.
template <int E, int P>
struct FltRounding {
  static constexpr int largest_exponent = (1 << (E - 1)) - 1;
  static constexpr int smallest_exponent = 1 - largest_exponent;  ///< of normal numbers
  static constexpr double smallest_normal = power_of_two(smallest_exponent);
  static constexpr double largest = (2 - power_of_two(1 - P)) * power_of_two(largest_exponent);
  /// From here on the nearest value would be 2^(largest_exponent + 1): infinity.
  static constexpr double overflow_threshold = (2 - power_of_two(-P)) * power_of_two(largest_exponent);

  /// The smallest subnormal number, which is also the spacing of all numbers below 2 smallest_normal. With P = 25 and
  /// E = 11 it is the double 2^-1046, itself subnormal, hence the two factors.
  static constexpr double spacing = smallest_normal * power_of_two(1 - P);
  /// A power of two that lifts tiny numbers out of double's own subnormal range. Only the widest exponent needs it:
  /// with E <= 10 every product of two numbers is a multiple of 2^-1068 and hence an exact double.
  static constexpr double lift = E == 11 ? power_of_two(512) : 1.0;

  /// Whether x rounds to a normal number because it lies between the smallest and the largest of them.
  static constexpr bool is_normal(double x) {
    constexpr auto first = std::bit_cast<std::uint64_t>(smallest_normal);
    constexpr auto last = std::bit_cast<std::uint64_t>(overflow_threshold);
    return std::bit_cast<std::uint64_t>(magnitude(x)) - first < last - first;
  }

  /// x, which is_normal(), to P bits: adds half a unit less one bit, and that bit where the unit is odd, so that the
  /// carry rounds ties to even; then cuts. A carry into the exponent is right as it stands.
  static constexpr double round_normal(double x) {
    constexpr unsigned dropped = 53U - static_cast<unsigned>(P);
    constexpr std::uint64_t below_half = (std::uint64_t{1} << (dropped - 1)) - 1;
    constexpr std::uint64_t kept = ~((std::uint64_t{1} << dropped) - 1);
    const auto bits = std::bit_cast<std::uint64_t>(x);
    return std::bit_cast<double>((bits + below_half + ((bits >> dropped) & 1U)) & kept);
  }

  /// x, |x| <= 2 smallest_normal * lift, to a multiple of spacing * lift. Adding 1.5 * 2^52 spacings leaves no bit for
  /// what lies below the spacing: double's own addition rounds it away, once, ties to even. A zero keeps the sign.
  static constexpr double round_tiny(double x) {
    constexpr double shifter = 1.5 * power_of_two(52 + smallest_exponent + 1 - P) * lift;
    const double rounded = (x + shifter) - shifter;
    constexpr std::uint64_t sign = std::uint64_t{1} << 63U;
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(rounded) | (std::bit_cast<std::uint64_t>(x) & sign));
  }
};

}  // namespace pyrasim
