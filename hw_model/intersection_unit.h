// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hw_model/fifo/fifo_port.h"
#include "hw_model/fifo/fifo_reader.h"
#include "hw_model/fifo/fifo_writer.h"
#include "hw_model/message.h"
#include "hw_model/plan/frame_setup.h"
#include "hw_model/plan/tester_parts.h"
#include "hw_model/record/work_sink.h"
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
  FifoPort<SampleMessage> samples{"samples"};  ///< to the shadow unit behind it, or to the classifier

  IntersectionUnit(const sc_core::sc_module_name& name, const FrameSetup& frame);

  /// Whether no light has shadows: samples go to the classifier.
  bool casts_no_shadows() const { return !casts_shadows_; }
  /// Of its rays, and of the shadow rays from what they saw.
  const Work& work() const { return work_; }
  std::vector<StagePart> parts() const {
    const SceneContents contents = intersector_.contents();
    return tester_parts(contents.surfaces, contents.inner_nodes, work_, cost_);
  }
  /// Of the arithmetic, where the constructor was told to count; costs a little.
  const ArithmeticEvents& events() const { return events_; }
  /// Takes corners that the host has traced before their time from there; none: traces all itself.
  void take_corners(CornersAhead* corners_ahead) { corners_ahead_ = corners_ahead; }
  /// `sink` is told of every ray from now on.
  void report_work_to(WorkSink& sink) { work_sink_ = &sink; }

 private:
  friend StageOf;
  struct Plan {
    Start start;
  };
  struct Ends {
    FifoReader<RayMessage> view_vector_generator;
    FifoWriter<SampleMessage> samples;
  };
  Ends ends() const { return {FifoReader(*view_vector_generator), FifoWriter(*samples)}; }
  static Plan next(const Ends& ends, Cycle ready) {
    return {Start(ready).needs_token(ends.view_vector_generator).needs_room(ends.samples)};
  }
  Cycle fire(Ends& ends, const Plan& plan);

  Sample nearest_hit(const RayMessage& ray, Work& work);
  /// The same, told to the sink.
  Sample reported_hit(const RayMessage& ray, Work& work);
  /// What the shadow unit has to do for the newest sample.
  void add_shadows(SampleMessage& message);

  Cycle latency_;
  IntersectionCost cost_;
  const Intersector& intersector_;
  bool count_events_;
  bool casts_shadows_;
  CornersAhead* corners_ahead_ = nullptr;
  WorkSink* work_sink_ = nullptr;
  Work work_;
  Cycle tests_ = 0;  ///< cost of all tests before the ray
  std::uint64_t shadow_rays_ = 0;
  Cycle shadow_tests_ = 0;
  ArithmeticEvents events_;
};

extern template class StageOf<IntersectionUnit>;

}  // namespace pyrasim::hw
