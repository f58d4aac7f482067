// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "run/outcome.h"
#include "run/run.h"

namespace pyrasim::cli {

/// What a change of one setting is expected to make of a frame.
struct Prediction {
  std::string change;  ///< as whatif takes it: "intersection.units=+1"
  hw::Cycle cycles;
};

/// Of every setting a step in either direction: one unit, one cycle of a latency, an interval or a cost, twice or half
/// of a depth. Estimates from the outcome of one frame on `run`'s machine, which has to have its critical path, without
/// another simulation; the fewest cycles first.
///
/// Each stretch of the critical path is expected to become as much longer or shorter as the change makes what it is
/// owed to: a unit's work, a latency, or the wait for a full FIFO, by its depth. No frame is expected to take less than
/// its work keeps the busiest box busy for. That another path becomes the critical one is not foreseen beyond that.
std::vector<Prediction> predictions(const Run& run, const Outcome& outcome);

}  // namespace pyrasim::cli
