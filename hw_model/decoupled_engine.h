// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "hw_model/pixel_scan.h"
#include "hw_model/stage.h"
#include "hw_model/subdivision_controller.h"
#include "hw_model/view_vector_generator.h"

namespace pyrasim::hw {

/// Runs a frame outside the SystemC kernel's time: stages fire as soon as the dates that decide their next firing are
/// known, however far ahead of the others.
///
/// That is exact. Most stages decide what to read and write from data alone; for them order does not matter. Two choose
/// by what has arrived first: the view-vector generator (corner or request) and the subdivision controller (accept or
/// issue). They fire when no other stage can, and the earlier of the two first: whatever is still unseen descends from
/// a firing not earlier than that, and every hop takes at least a cycle. The generator then goes on alone for as long
/// as nothing that it set off could have come back to it.
class DecoupledEngine {
 public:
  /// `controller`: none where nothing is subdivided. `round_trip`: the least cycles from a ray's issue to a firing of
  /// the controller that it makes possible; `request_latency`: from there to the request being visible to the
  /// generator.
  DecoupledEngine(const std::vector<Stage*>& stages, PixelScan& scan, ViewVectorGenerator& generator,
                  SubdivisionController* controller, Cycle round_trip, Cycle request_latency);

  /// Runs until no stage can fire.
  void run();

 private:
  void run_generator(const Start& first);
  Cycle controller_date() { return controller_ == nullptr ? never : controller_->next().at(); }

  WorkList work_;
  PixelScan& scan_;
  ViewVectorGenerator& generator_;
  SubdivisionController* controller_;
  Cycle round_trip_;
  Cycle request_latency_;
};

}  // namespace pyrasim::hw
