// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "hw_model/cycle.h"

namespace pyrasim::hw {

/// What a FIFO's use amounted to. Tokens count from the cycle of their write to that of their read, both included.
struct FifoStatistics {
  std::size_t depth = 0;
  std::size_t max = 0;             ///< most tokens in it at once
  std::uint64_t token_cycles = 0;  ///< sum over tokens of the cycles spent in it; divided by the frame's: the mean
  std::uint64_t tokens = 0;        ///< that were read
  Cycle starved = 0;               ///< cycles that the reader waited for a token from here
  Cycle blocked = 0;               ///< cycles that the writer waited for room in here
  friend bool operator==(const FifoStatistics&, const FifoStatistics&) = default;
};

}  // namespace pyrasim::hw
