// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hw_model/cycle.h"

namespace pyrasim::hw {

/// The part of a frame that traces show.
struct TraceWindow {
  Cycle from = 0;
  Cycle to = never;                                                 ///< the first cycle that is not shown
  std::uint64_t limit = std::numeric_limits<std::uint64_t>::max();  ///< bytes of a file, with which its trace ends
  std::optional<Cycle> full;                                        ///< where it did; then `to` is no later
  std::vector<std::string> units;  ///< patterns of the names of units and FIFOs, as a shell's (*, ?, [a-z]); none: all

  std::vector<std::pair<int, int>> pixels;  ///< rows and columns on the screen, of what is rendered; none: all
  bool critical_path = false;               ///< where a format has a place for it
  bool detail = false;                      ///< likewise: what units work on, valid and ready of FIFOs

  bool shows(std::string_view name) const;
  /// Whether [begin, end) has a cycle in it.
  bool overlaps(Cycle begin, Cycle end) const { return begin < to && end > from; }
  /// Ends at `now` where the file has come to its limit with `bytes`. What has begun before may still be written.
  void end_if_full(std::uint64_t bytes, Cycle now) {
    if (bytes < limit || full || now >= to) return;
    full = to = now;
  }
};

}  // namespace pyrasim::hw
