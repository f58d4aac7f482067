// SPDX-License-Identifier: Apache-2.0
// The number formats that a datapath can have, by name.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace pyrasim {

enum class NumberKind : std::uint8_t {
  processor,  ///< double and float, the processor's own
  floating,   ///< Flt
  fixed       ///< Fix, rounding to nearest with ties to even, saturating
};

struct NumberFormat {
  NumberKind kind = NumberKind::processor;
  int bits = 64;              ///< of a number in all, the sign included
  int exponent_bits = 11;     ///< 0 in fixed point
  int significand_bits = 53;  ///< the hidden one included; in fixed point all but the sign
  int fraction_bits = 0;      ///< after the binary point; 0 in floating point

  /// float, the processor's own.
  static constexpr NumberFormat single() { return {NumberKind::processor, 32, 8, 24, 0}; }
  static constexpr NumberFormat floating(int exponent_bits, int significand_bits) {
    return {NumberKind::floating, exponent_bits + significand_bits, exponent_bits, significand_bits, 0};
  }
  static constexpr NumberFormat fixed(int bits, int fraction_bits) {
    return {NumberKind::fixed, bits, 0, bits - 1, fraction_bits};
  }

  /// Whether there are numbers of that format: of the processor's kind double and float, of the others by the limits
  /// below.
  bool within_limits() const;
  /// "double", "float", "fp16", "bf16", "tf32", "fp24", "e8p12", "fix64.28"
  std::string name() const;
  friend bool operator==(const NumberFormat&, const NumberFormat&) = default;
};

inline constexpr NumberFormat fp16 = NumberFormat::floating(5, 11);  ///< IEEE 754 binary16
inline constexpr NumberFormat bf16 = NumberFormat::floating(8, 8);   ///< bfloat16
inline constexpr NumberFormat tf32 = NumberFormat::floating(8, 11);  ///< TensorFloat-32: 19 bits
inline constexpr NumberFormat fp24 = NumberFormat::floating(7, 17);  ///< 24 bits

/// Of Flt: the exponent must fit into that of double, and with 2P + 2 <= 53 an operation in double does not round
/// twice.
inline constexpr int min_exponent_bits = 2;
inline constexpr int max_exponent_bits = 11;
inline constexpr int min_significand_bits = 2;
inline constexpr int max_significand_bits = 25;
/// Of Fix, the sign included; all of them but the sign can be fraction bits.
inline constexpr int min_fixed_bits = 2;
inline constexpr int max_fixed_bits = 64;

/// A choice of formats to compare, double first: what a study takes that names none.
const std::vector<NumberFormat>& number_formats();

/// The format of that name: double, float, fp16, bf16, tf32, fp24, eEpP or fixW.F within the limits above. "e5p11",
/// "e8p8", "e8p11" and "e7p17" are other names of fp16, bf16, tf32 and fp24. Throws UsageError that says what is
/// allowed.
NumberFormat parse_number_format(std::string_view name);

}  // namespace pyrasim
