// SPDX-License-Identifier: Apache-2.0
// Why a frame took as long as it did: pure functions of a processor whose frame is over.
#pragma once

#include <string>
#include <vector>

#include "hw_model/processor.h"

namespace pyrasim::hw {

/// Cycles that a stage waited for one FIFO.
struct Wait {
  const FifoBase* fifo;
  bool starved;  ///< for a token from it; else for room in it
  Cycle cycles;
};

/// Every FIFO that a stage waited for, the longest wait first. Their sum is the stage's starved + blocked.
std::vector<Wait> waits(const Processor& processor, const Stage& stage);

/// A box in the chain of causes, and what it waited for most. The intersection units count as one box: all figures are
/// means over the stages of the box.
struct BottleneckLink {
  std::string unit;  ///< the stage's name, or "intersection_units"
  double busy;       ///< share of the frame's cycles
  /// What leads on to the next link, with its share of the frame's cycles; 0 at the end of the chain.
  double waited = 0;
  bool starved = false;  ///< waited for the next link's tokens; else for room in its FIFO
  friend bool operator==(const BottleneckLink&, const BottleneckLink&) = default;
};

/// From the tree accumulator, which finishes pixels, to the cause: the box at the other end of the FIFOs for which a
/// box waited longest comes next. Ends at the busiest box of all, if it is busy for longer than it waits for any other.
/// Where it comes back to a box instead, that box is repeated as the last link: the frame waits for the latency of that
/// loop.
std::vector<BottleneckLink> bottleneck_chain(const Processor& processor);
/// Whether the chain's last box is one of those before: the frame waits for the latency of a loop through it.
bool closes_loop(const std::vector<BottleneckLink>& chain);
/// What the chain ends with: "intersection_units, busy 99.6 %", or "the latency of a loop through ...".
std::string cause_text(const std::vector<BottleneckLink>& chain);
/// "tree_accumulator busy 10.3 % <- starved by pyramid_classifier busy 15.7 % <- ..."
std::string bottleneck_text(const std::vector<BottleneckLink>& chain);

/// What the work alone imposes: no schedule of the same work on as many units takes fewer cycles.
struct LowerBound {
  std::string unit;  ///< the busiest; "intersection_units" for all of them together
  Cycle cycles;      ///< its busy cycles; of the intersection units their sum, divided by their number, rounded up
  friend bool operator==(const LowerBound&, const LowerBound&) = default;
};
LowerBound lower_bound(const Processor& processor);

}  // namespace pyrasim::hw
