// SPDX-License-Identifier: Apache-2.0
#include "numeric/flt_format.h"

#include <stdexcept>

namespace pyrasim {

FltFormat::FltFormat(const NumberFormat& format) : exponent_bits_(format.exponent_bits) {
  if (format.kind != NumberKind::floating || !format.within_limits()) {
    throw std::logic_error("Flt has no format " + format.name());
  }
  const int significand_bits = format.significand_bits;
  const int largest_exponent = (1 << (static_cast<unsigned>(exponent_bits_) - 1)) - 1;
  const int smallest_exponent = 1 - largest_exponent;
  largest_ = (2 - power_of_two(1 - significand_bits)) * power_of_two(largest_exponent);
  const double threshold = (2 - power_of_two(-significand_bits)) * power_of_two(largest_exponent);
  smallest_normal_ = std::bit_cast<std::uint64_t>(power_of_two(smallest_exponent));
  normal_ = std::bit_cast<std::uint64_t>(threshold) - smallest_normal_;
  dropped_ = 53U - static_cast<unsigned>(significand_bits);
  below_half_ = (std::uint64_t{1} << (dropped_ - 1)) - 1;
  kept_ = ~((std::uint64_t{1} << dropped_) - 1);
  // Of 11 and 25 bits it is the double 2^-1046, itself subnormal, hence the two factors.
  spacing_ = power_of_two(smallest_exponent) * power_of_two(1 - significand_bits);
  if (exponent_bits_ == 11) lift_ = power_of_two(512);
  shifter_ = 1.5 * power_of_two(52 + smallest_exponent + 1 - significand_bits) * lift_;
}

}  // namespace pyrasim
