// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "hw_model/color_unit.h"
#include "hw_model/frame_buffer.h"
#include "hw_model/intersection_unit.h"
#include "hw_model/pixel_scan.h"
#include "hw_model/run_control.h"
#include "hw_model/stage/stage.h"
#include "hw_model/stage/work_list.h"
#include "hw_model/subdivision_controller.h"
#include "hw_model/trace/event_stream.h"
#include "hw_model/view_vector_generator.h"
#include "hw_model/wire.h"

namespace pyrasim::hw {

/// Runs a frame outside the SystemC kernel's time: stages fire as soon as the dates that decide their next firing are
/// known, however far ahead of the others.
///
/// That is exact. Most stages decide what to read and write from data alone; for them order does not matter. Two choose
/// by what has arrived first: the view-vector generator (corner or request, and under first_free the unit) and the
/// subdivision controller (accept or issue). They fire when no other stage can, and the earlier of the two first:
/// whatever is still unseen descends from a firing not earlier than that, and every hop takes at least a cycle. Where
/// it does not choose among units, the generator then goes on alone for as long as nothing that it set off could have
/// come back to it.
class DecoupledEngine {
 public:
  /// The stages that the engine knows by name. `controller`: none where nothing is subdivided.
  struct Boxes {
    PixelScan& scan;
    ViewVectorGenerator& generator;
    std::vector<IntersectionUnit*> units;
    bool has_shadow_units;  ///< behind these
    SubdivisionController* controller;
    ColorUnit& color_unit;
    FrameBuffer& frame_buffer;
  };

  DecoupledEngine(std::vector<Stage*> stages, const std::vector<Wire>& wires, Boxes boxes, const MachineSpec& spec);

  /// Runs until no stage can fire, or the two that choose could only fire after control.last.
  /// What has happened is handed on from `events` whenever that pays.
  void run(const RunControl& control, EventStream& events);

 private:
  void settle();
  Cycle watermark();
  void run_controller(Cycle first);
  void run_generator(Cycle first);
  Cycle lookahead(Cycle first) const;
  Cycle controller_date();

  std::vector<Stage*> stages_;
  Boxes boxes_;
  Cycle generator_latency_;
  Cycle unit_latency_;  ///< the least from a ray's start in a unit to its sample at the classifier
  Cycle request_latency_;
  Cycle controller_date_ = never;  ///< of the controller's next firing, as long as it sleeps
  WorkList work_;
};

}  // namespace pyrasim::hw
