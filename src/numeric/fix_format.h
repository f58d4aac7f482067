// SPDX-License-Identifier: Apache-2.0
// The integers that a fixed-point number can be, and what becomes of one that is out of range: the overflow modes of
// IEEE 1666-2011 (SystemC), 7.10.9, under their names there.
#pragma once

#include <cstdint>

#include "numeric/int128.h"
#include "numeric/number_format.h"

namespace pyrasim {

enum class Overflow : std::uint8_t {
  SC_SAT,       ///< the nearest value of the format
  SC_SAT_ZERO,  ///< zero
  SC_SAT_SYM,   ///< as SC_SAT, in a range without the most negative value, so that it is symmetric
  SC_WRAP       ///< modulo 2^bits (n_bits = 0)
};

/// Two's complement of so many bits, the sign included, some of them after the binary point.
class FixFormat {
 public:
  /// None: it contains no number.
  constexpr FixFormat() = default;
  /// Throws std::logic_error if it is no fixed-point format within the limits.
  explicit FixFormat(const NumberFormat& format);

  NumberFormat number_format() const { return NumberFormat::fixed(bits_, fraction_bits_); }
  int fraction_bits() const { return fraction_bits_; }
  double resolution() const { return resolution_; }  ///< 2^-fraction_bits
  std::int64_t largest() const { return largest_; }
  std::int64_t smallest(Overflow mode) const { return mode == Overflow::SC_SAT_SYM ? -largest_ : -largest_ - 1; }

  template <class Integer>
  bool contains(Integer n, Overflow mode) const {
    return n >= smallest(mode) && n <= largest_;
  }

  /// What an integer outside the range becomes. Without a format it throws std::logic_error: every one comes here then.
  std::int64_t overflowed(Int128 n, Overflow mode) const;

 private:
  std::int64_t largest_ = -1;
  double resolution_ = 0;
  int bits_ = 0;
  int fraction_bits_ = 0;
};

/// The format in which Fix computes on this thread. Set by FormatScope.
inline constinit thread_local FixFormat fix_format{};

}  // namespace pyrasim
