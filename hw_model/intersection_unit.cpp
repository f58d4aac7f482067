// SPDX-License-Identifier: Apache-2.0
#include "hw_model/intersection_unit.h"

namespace pyrasim::hw {

IntersectionUnit::IntersectionUnit(const sc_core::sc_module_name& name, const FrameSetup& frame)
    : StageOf(name),
      latency_(frame.spec.intersection_latency),
      cost_(frame.spec.intersection_cost),
      intersector_(frame.intersector),
      count_events_(frame.options.formats.counts_events()) {}

Cycle IntersectionUnit::fire(Ends& ends, const Plan& plan) {
  const Cycle now = plan.start.at();
  const RayMessage& ray = ends.view_vector_generator.front();
  const Sample sample = nearest_hit(ray, work_);
  const Cycle tests = cost_of_tests();
  const Cycle occupied = cost_.ray + tests - tests_;
  tests_ = tests;
  ends.pyramid_classifier.write_made(
      [&] {
        return SampleMessage{sample, ray.tag, ray.subdivision};
      },
      now, occupied - 1 + latency_);
  ends.view_vector_generator.pop(now);
  return occupied;
}

Sample IntersectionUnit::nearest_hit(const RayMessage& ray, Work& work) {
  if (corners_ahead_ != nullptr && !ray.subdivision) return corners_ahead_->trace(ray.point, ray.view_vector, work);
  if (count_events_) return counting_events(events_, [&] { return intersector_.intersect(ray.view_vector, work); });
  return intersector_.intersect(ray.view_vector, work);
}

Cycle IntersectionUnit::cost_of_tests() const {
  Cycle cycles = cost_.box_test * work_.box_tests;
  for (std::size_t kind = 0; kind < surface_kinds; ++kind) {
    cycles += cost_.surface_test[kind] * work_.surface_tests[kind];
  }
  return cycles;
}

template class StageOf<IntersectionUnit>;

}  // namespace pyrasim::hw
