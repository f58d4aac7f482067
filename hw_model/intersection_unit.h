// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hw_model/fifo/fifo_port.h"
#include "hw_model/fifo/fifo_reader.h"
#include "hw_model/fifo/fifo_writer.h"
#include "hw_model/message.h"
#include "hw_model/plan/frame_setup.h"
#include "hw_model/plan/tester_parts.h"
#include "hw_model/stage/stage_of.h"
#include "intersect/corners_ahead.h"
#include "intersect/datapath_formats.h"
#include "intersect/intersector.h"

namespace pyrasim::hw {

/// Finds the nearest hit of one ray after the other. A ray occupies the unit for as long as its work takes: the cost of
/// its box tests and surface tests as the algorithm counted them. The cell for the result is taken when the ray starts.
class IntersectionUnit final : public StageOf<IntersectionUnit> {
 public:
  FifoPort<RayMessage> view_vector_generator{"view_vector_generator"};
  FifoPort<SampleMessage> pyramid_classifier{"pyramid_classifier"};

  IntersectionUnit(const sc_core::sc_module_name& name, const FrameSetup& frame);

  const Work& work() const { return work_; }
  std::vector<StagePart> parts() const { return tester_parts(intersector_.contents(), work_, cost_); }
  /// Of the arithmetic, where the constructor was told to count; costs a little.
  const ArithmeticEvents& events() const { return events_; }
  /// Takes corners that the host has traced before their time from there; none: traces all itself.
  void take_corners(CornersAhead* corners_ahead) { corners_ahead_ = corners_ahead; }

 private:
  friend StageOf;
  struct Plan {
    Start start;
  };
  struct Ends {
    FifoReader<RayMessage> view_vector_generator;
    FifoWriter<SampleMessage> pyramid_classifier;
  };
  Ends ends() const { return {FifoReader(*view_vector_generator), FifoWriter(*pyramid_classifier)}; }
  static Plan next(const Ends& ends, Cycle ready) {
    return {Start(ready).needs_token(ends.view_vector_generator).needs_room(ends.pyramid_classifier)};
  }
  Cycle fire(Ends& ends, const Plan& plan);

  Sample nearest_hit(const RayMessage& ray, Work& work);
  /// In cycles, of all tests so far.
  Cycle cost_of_tests() const;

  Cycle latency_;
  IntersectionCost cost_;
  const Intersector& intersector_;
  bool count_events_;
  CornersAhead* corners_ahead_ = nullptr;
  Work work_;
  Cycle tests_ = 0;  ///< cost_of_tests() before the ray
  ArithmeticEvents events_;
};

extern template class StageOf<IntersectionUnit>;

}  // namespace pyrasim::hw
