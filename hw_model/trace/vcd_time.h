// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "hw_model/cycle.h"

namespace pyrasim::hw {

/// The time of a VCD file, whose unit is 1, 10 or 100 of s, ms, us, ns, ps or fs (IEEE 1364-2005, clause 18).
///
/// The unit is the largest in which the clock's period is a whole number, and dates are exact: 200 MHz make 5 steps of
/// 1 ns a cycle. Where there is none down to 1 fs (333 MHz) it is 1 fs, or 1 ps below 1 MHz so that dates fit into 64
/// bits, and a date is the cycle times the period rounded once: within half a unit, however long the frame.
class VcdTime {
 public:
  explicit VcdTime(double clock_mhz);

  /// "1 ns"
  const std::string& unit() const { return unit_; }
  /// The start of `cycle`, in units.
  std::uint64_t date(Cycle cycle) const;

 private:
  double clock_mhz_;
  std::uint64_t steps_ = 0;  ///< units a cycle, where that is a whole number; else 0
  double units_ = 0;         ///< in a microsecond
  std::string unit_;
};

}  // namespace pyrasim::hw
