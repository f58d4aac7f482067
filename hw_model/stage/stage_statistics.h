// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "hw_model/cycle.h"

namespace pyrasim::hw {

/// Where a stage's cycles went. The four add up to the frame's cycles.
struct StageStatistics {
  Cycle busy = 0;
  Cycle starved = 0;  ///< no input
  Cycle blocked = 0;  ///< no room for the output
  Cycle idle = 0;     ///< frame not begun, or over
  std::uint64_t firings = 0;
  friend bool operator==(const StageStatistics&, const StageStatistics&) = default;
};

}  // namespace pyrasim::hw
