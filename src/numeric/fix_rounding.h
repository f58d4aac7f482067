// SPDX-License-Identifier: Apache-2.0
// How a number that lies between two fixed-point values becomes one, and what becomes of one that is out of range:
// the quantisation and overflow modes of IEEE 1666-2011 (SystemC), 7.10.9, under their names there.
#pragma once

#include <cmath>
#include <cstdint>
#include <type_traits>

namespace pyrasim {

__extension__ using Int128 = __int128;
__extension__ using UInt128 = unsigned __int128;

enum class Rounding : std::uint8_t {
  SC_RND,          ///< to nearest, ties towards plus infinity
  SC_RND_ZERO,     ///< to nearest, ties towards zero
  SC_RND_MIN_INF,  ///< to nearest, ties towards minus infinity
  SC_RND_INF,      ///< to nearest, ties away from zero
  SC_RND_CONV,     ///< to nearest, ties to even
  SC_TRN,          ///< towards minus infinity
  SC_TRN_ZERO      ///< towards zero
};

enum class Overflow : std::uint8_t {
  SC_SAT,       ///< the nearest value of the format
  SC_SAT_ZERO,  ///< zero
  SC_SAT_SYM,   ///< as SC_SAT, in a range without the most negative value, so that it is symmetric
  SC_WRAP       ///< modulo 2^W (n_bits = 0)
};

/// A real number in units of the format's last place: `floor`, and above it half a unit where `half`, and then some
/// more but less than half a unit where `sticky`.
template <class Integer>
struct Unrounded {
  Integer floor;
  bool half;
  bool sticky;

  constexpr bool exact() const { return !(half || sticky); }
};

/// value / 2^places, 0 <= places < the bits of Integer.
template <class Integer>
constexpr Unrounded<Integer> scaled_down(Integer value, int places) {
  if (places == 0) return {value, false, false};
  const Integer rest = value & ((Integer{1} << places) - 1);
  const Integer half = Integer{1} << (places - 1);
  return {value >> places, rest >= half, (rest & (half - 1)) != 0};
}

/// numerator / denominator; the denominator is not 0.
constexpr Unrounded<Int128> quotient(Int128 numerator, std::int64_t denominator) {
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
constexpr Unrounded<Int128> square_root(UInt128 square) {
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
template <Rounding R, class Integer>
constexpr Integer rounded(const Unrounded<Integer>& x) {
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

/// The integers of W bits in two's complement that the overflow mode uses.
template <int W, Overflow O>
struct FixRange {
  static constexpr std::int64_t largest = static_cast<std::int64_t>((std::uint64_t{1} << (W - 1)) - 1);
  static constexpr std::int64_t smallest = O == Overflow::SC_SAT_SYM ? -largest : -largest - 1;

  template <class Integer>
  static constexpr bool contains(Integer n) {
    return n >= smallest && n <= largest;
  }

  /// What an integer outside the range becomes.
  template <class Integer>
  static constexpr std::int64_t overflowed(Integer n) {
    if constexpr (O == Overflow::SC_SAT_ZERO) return 0;
    if constexpr (O == Overflow::SC_WRAP) {
      constexpr unsigned spare = 64 - W;
      return static_cast<std::int64_t>(static_cast<std::uint64_t>(n) << spare) >> spare;
    }
    return n < 0 ? smallest : largest;
  }
};

}  // namespace pyrasim
