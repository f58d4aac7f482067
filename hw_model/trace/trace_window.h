// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "hw_model/cycle.h"

namespace pyrasim::hw {

/// The part of a frame that traces show.
struct TraceWindow {
  Cycle from = 0;
  Cycle to = never;                ///< the first cycle that is not shown
  std::vector<std::string> units;  ///< patterns of the names of units and FIFOs, as a shell's (*, ?, [a-z]); none: all

  bool shows(std::string_view name) const;
  /// Whether [begin, end) has a cycle in it.
  bool overlaps(Cycle begin, Cycle end) const { return begin < to && end > from; }
};

}  // namespace pyrasim::hw
