// SPDX-License-Identifier: Apache-2.0
#include "numeric/fix_format.h"

#include <cmath>
#include <stdexcept>

namespace pyrasim {

FixFormat::FixFormat(const NumberFormat& format)
    : resolution_(std::ldexp(1.0, -format.fraction_bits)), bits_(format.bits), fraction_bits_(format.fraction_bits) {
  if (format.kind != NumberKind::fixed || !format.within_limits()) {
    throw std::logic_error("Fix has no format " + format.name());
  }
  largest_ = static_cast<std::int64_t>((std::uint64_t{1} << static_cast<unsigned>(bits_ - 1)) - 1);
}

std::int64_t FixFormat::overflowed(Int128 n, Overflow mode) const {
  if (bits_ == 0) throw std::logic_error("Fix computes without a format: no FormatScope<Fix>");
  switch (mode) {
    case Overflow::SC_SAT_ZERO:
      return 0;
    case Overflow::SC_WRAP: {
      const auto spare = static_cast<unsigned>(64 - bits_);
      return static_cast<std::int64_t>(static_cast<std::uint64_t>(n) << spare) >> spare;
    }
    case Overflow::SC_SAT:
    case Overflow::SC_SAT_SYM:
      break;
  }
  return n < 0 ? smallest(mode) : largest_;
}

}  // namespace pyrasim
