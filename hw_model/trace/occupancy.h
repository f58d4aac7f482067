// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "hw_model/cycle.h"

namespace pyrasim::hw {

/// How full a FIFO was over time, at a bounded number of dates: whenever there are too many, every other one is
/// dropped. A token counts from the cycle of its write to that of its read, both included.
class Occupancy {
 public:
  static constexpr std::size_t most_points = 256;

  /// `present`: tokens before the frame begins.
  explicit Occupancy(std::size_t present) : present_(static_cast<std::int64_t>(present)) {}

  void write(Cycle at) { ++change_from(at); }
  void read(Cycle at) { --change_from(at + 1); }
  /// Makes the points reach to the end of a frame of `cycles`, however early the last token was read.
  void end_frame(Cycle cycles);

  /// Cycles between two points; a power of two.
  Cycle stride() const { return Cycle{1} << shift_; }
  /// Tokens at the cycles 0, stride, 2 stride ... below `cycles`, of which end_frame() has been told.
  std::vector<std::size_t> points(Cycle cycles) const;

 private:
  std::int64_t& change_from(Cycle at);
  void drop_every_other();

  std::int64_t present_;
  int shift_ = 0;
  std::vector<std::int64_t> changes_;  ///< [k]: written less read after point k - 1, up to point k
};

}  // namespace pyrasim::hw
