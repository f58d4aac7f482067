// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hw_model/fifo/fifo_port.h"
#include "hw_model/fifo/fifo_reader.h"
#include "hw_model/fifo/fifo_writer.h"
#include "hw_model/message.h"
#include "hw_model/plan/frame_setup.h"
#include "hw_model/plan/tester_parts.h"
#include "hw_model/stage/stage_of.h"

namespace pyrasim::hw {

/// Follows the shadow rays of one sample after the other, from the place that was seen to each light with shadows that
/// it faces; one stands behind each intersection unit. Every sample passes through it, in order, and occupies it for a
/// cycle, its shadow rays and the tests that they take. The host traced them with the view ray already.
class ShadowUnit final : public StageOf<ShadowUnit> {
 public:
  FifoPort<SampleMessage> intersection_unit{"intersection_unit"};
  FifoPort<SampleMessage> pyramid_classifier{"pyramid_classifier"};

  ShadowUnit(const sc_core::sc_module_name& name, const FrameSetup& frame);

  /// `work`: that of its rays, which the intersection unit before it counts.
  void account_for(const ShadowWork& work) { work_ = &work; }
  std::vector<StagePart> parts() const {
    return tester_parts(contents_.surfaces, contents_.shadow_inner_nodes, work_->tests, test_cost_);
  }

 private:
  friend StageOf;
  struct Plan {
    Start start;
  };
  struct Ends {
    FifoReader<SampleMessage> intersection_unit;
    FifoWriter<SampleMessage> pyramid_classifier;
  };
  Ends ends() const { return {FifoReader(*intersection_unit), FifoWriter(*pyramid_classifier)}; }
  static Plan next(const Ends& ends, Cycle ready) {
    return {Start(ready).needs_token(ends.intersection_unit).needs_room(ends.pyramid_classifier)};
  }
  Cycle fire(Ends& ends, const Plan& plan);

  ShadowTiming timing_;
  IntersectionCost test_cost_;
  SceneContents contents_;
  const ShadowWork* work_ = nullptr;
};

extern template class StageOf<ShadowUnit>;

}  // namespace pyrasim::hw
