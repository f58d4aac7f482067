// SPDX-License-Identifier: Apache-2.0
#include "hw_model/trace/vcd_time.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace pyrasim::hw {
namespace {

constexpr double femtoseconds = 1e9;  ///< in a microsecond, the period of 1 MHz

}  // namespace

VcdTime::VcdTime(double clock_mhz) : clock_mhz_(clock_mhz) {
  constexpr std::array<const char*, 6> names{"fs", "ps", "ns", "us", "ms", "s"};
  const double period = femtoseconds / clock_mhz;
  if (period == std::floor(period)) {
    steps_ = static_cast<std::uint64_t>(period);
    std::size_t power = 0;  // of ten
    for (; steps_ % 10 == 0 && power < 17; ++power) steps_ /= 10;
    unit_ = fmt::format("{} {}", std::array{1, 10, 100}[power % 3], names[power / 3]);
  } else {
    units_ = clock_mhz >= 1 ? femtoseconds : femtoseconds / 1000;
    unit_ = clock_mhz >= 1 ? "1 fs" : "1 ps";
  }
}

/// Of 64 bits of significand.
std::uint64_t VcdTime::date(Cycle cycle) const {
  if (steps_ > 0) return cycle * steps_;
  return static_cast<std::uint64_t>(std::round(static_cast<long double>(cycle) * static_cast<long double>(units_) /
                                               static_cast<long double>(clock_mhz_)));
}

}  // namespace pyrasim::hw
