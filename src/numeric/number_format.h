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

  /// "double", "float", "fp16", "bf16", "tf32", "fp24", "e8p12", "fix64.28"
  std::string name() const;
  friend bool operator==(const NumberFormat&, const NumberFormat&) = default;
};

/// All formats that are compiled in; the first is the default. What with_number_type() knows.
const std::vector<NumberFormat>& number_formats();

/// The format of that name; "e8p8" and "e8p11" are other names of bf16 and tf32, "e5p11" and "e7p17" of fp16 and fp24.
/// Throws UsageError that lists the names where there is none.
NumberFormat parse_number_format(std::string_view name);

}  // namespace pyrasim
