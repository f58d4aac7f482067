// SPDX-License-Identifier: Apache-2.0
#include "hw_model/intersection_unit.h"

#include <utility>

namespace pyrasim::hw {

IntersectionUnit::IntersectionUnit(const sc_core::sc_module_name& name, const FrameSetup& frame)
    : StageOf(name),
      latency_(frame.spec.intersection_latency),
      cost_(frame.spec.intersection_cost),
      intersector_(frame.intersector),
      count_events_(frame.options.formats.counts_events()),
      casts_shadows_(frame.intersector.contents().lights_with_shadows > 0) {}

Cycle IntersectionUnit::fire(Ends& ends, const Plan& plan) {
  const Cycle now = plan.start.at();
  const RayMessage& ray = ends.view_vector_generator.front();
  const Sample sample = work_sink_ == nullptr ? nearest_hit(ray, work_) : reported_hit(ray, work_);
  const Cycle tests = cost_of(work_, cost_);
  const Cycle occupied = cost_.ray + tests - tests_;
  tests_ = tests;
  ends.samples.write_made(
      [&] {
        SampleMessage message{sample, ray.tag, ray.subdivision};
        if (casts_shadows_) add_shadows(message);
        return message;
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

[[gnu::noinline]] Sample IntersectionUnit::reported_hit(const RayMessage& ray, Work& work) {
  Work own;
  const Sample sample = nearest_hit(ray, own);
  work_sink_->ray(ray.point, sample.seen, own);
  work += own;
  return sample;
}

void IntersectionUnit::add_shadows(SampleMessage& message) {
  const std::uint64_t rays = work_.shadow.total_rays();
  const Cycle tests = cost_of(work_.shadow.tests, cost_);
  message.shadow_rays = static_cast<std::uint32_t>(rays - std::exchange(shadow_rays_, rays));
  message.shadow_tests = tests - std::exchange(shadow_tests_, tests);
}

template class StageOf<IntersectionUnit>;

}  // namespace pyrasim::hw
