// SPDX-License-Identifier: Apache-2.0
// How a number that lies between two fixed-point values becomes one: the quantisation modes of IEEE 1666-2011
// (SystemC), 7.10.9, under their names there.
#pragma once

#include <cmath>
#include <cstdint>
#include <type_traits>

#include "numeric/int128.h"

namespace pyrasim {

enum class Rounding : std::uint8_t {
  SC_RND,          ///< to nearest, ties towards plus infinity
  SC_RND_ZERO,     ///< to nearest, ties towards zero
  SC_RND_MIN_INF,  ///< to nearest, ties towards minus infinity
  SC_RND_INF,      ///< to nearest, ties away from zero
  SC_RND_CONV,     ///< to nearest, ties to even
  SC_TRN,          ///< towards minus infinity
  SC_TRN_ZERO      ///< towards zero
};

/// A real number in units of the format's last place: `floor`, and above it half a unit where `half`, and then some
/// more but less than half a unit where `sticky`.
struct Unrounded {
  Int128 floor;
  bool half;
  bool sticky;

  constexpr bool exact() const { return !(half || sticky); }
};

/// value * 2^places, 0 <= places < 64.
constexpr Int128 shifted_left(std::int64_t value, int places) {
  const auto high = (value >> 1) >> (63 - places);
  const auto low = static_cast<std::uint64_t>(value) << places;
  return (static_cast<Int128>(high) << 64U) | low;
}

/// value / 2^places, 0 <= places < 64.
constexpr Unrounded scaled_down(Int128 value, int places) {
  // In words: a shift of 128 bits would allow for more places.
  const auto high = static_cast<std::int64_t>(value >> 64U);
  const auto low = static_cast<std::uint64_t>(value);
  const std::uint64_t rest_mask = (std::uint64_t{1} << places) - 1;
  const std::uint64_t half = (rest_mask >> 1U) + 1;
  const auto floor_low = (low >> places) | (static_cast<std::uint64_t>(high) << 1U << (63 - places));
  const Int128 floor = (static_cast<Int128>(high >> places) << 64U) | floor_low;
  const std::uint64_t rest = low & rest_mask;
  return {floor, (rest & half) != 0, (rest & (rest_mask >> 1U)) != 0};
}

/// numerator / denominator; the denominator is not 0.
constexpr Unrounded quotient(Int128 numerator, std::int64_t denominator) {
  const bool fits = numerator == static_cast<std::int64_t>(numerator) && denominator != -1;
  // A division of 64 bits takes a fraction of the time of one of 128.
  Int128 floor = fits ? static_cast<std::int64_t>(numerator) / denominator : numerator / denominator;
  Int128 rest = numerator - floor * denominator;
  if (rest != 0 && (rest < 0) != (denominator < 0)) {
    --floor;
    rest += denominator;
  }
  const Int128 size = denominator < 0 ? -static_cast<Int128>(denominator) : denominator;
  const Int128 twice = 2 * (rest < 0 ? -rest : rest);
  return {floor, twice >= size, twice != size && twice != 0};
}

/// The square root of a number < 2^126. (floor + 1/2)^2 is no integer, so that a root is never half-way.
constexpr Unrounded square_root(UInt128 square) {
  if (square == 0) return {0, false, false};
  // Heron's iteration from above falls until it reaches the floor, at once from the root in double: that is off by
  // 2^-52 of itself at most, and 2^-50 more and one more on top lie above.
  UInt128 root = UInt128{1} << 63U;
  if (!std::is_constant_evaluated()) {
    root = static_cast<UInt128>(std::sqrt(static_cast<double>(square)) * (1 + 0x1p-50)) + 1;
  }
  for (UInt128 next = (root + square / root) / 2; next < root; next = (root + square / root) / 2) root = next;
  const UInt128 rest = square - root * root;
  return {static_cast<Int128>(root), rest > root, rest != 0};
}

/// To an integer of the last place. Ties can be told apart because `half` without `sticky` is exactly one half.
template <Rounding R>
constexpr Int128 rounded(const Unrounded& x) {
  const bool negative = x.floor < 0;
  bool up = false;
  if constexpr (R == Rounding::SC_RND) up = x.half;
  if constexpr (R == Rounding::SC_RND_ZERO) up = x.half & (x.sticky | negative);
  if constexpr (R == Rounding::SC_RND_MIN_INF) up = x.half & x.sticky;
  if constexpr (R == Rounding::SC_RND_INF) up = x.half & (x.sticky | !negative);
  if constexpr (R == Rounding::SC_RND_CONV) up = x.half & (x.sticky | ((x.floor & 1) != 0));
  if constexpr (R == Rounding::SC_TRN_ZERO) up = negative & (x.half | x.sticky);
  return x.floor + (up ? 1 : 0);
}

}  // namespace pyrasim
