// SPDX-License-Identifier: Apache-2.0
#include "hw_model/shadow_unit.h"

namespace pyrasim::hw {

ShadowUnit::ShadowUnit(const sc_core::sc_module_name& name, const FrameSetup& frame)
    : StageOf(name),
      timing_(frame.spec.shadow_unit),
      test_cost_(frame.spec.intersection_cost),
      contents_(frame.intersector.contents()) {}

Cycle ShadowUnit::fire(Ends& ends, const Plan& plan) {
  const Cycle now = plan.start.at();
  const SampleMessage& message = ends.intersection_unit.front();
  const Cycle occupied = 1 + timing_.ray * message.shadow_rays + message.shadow_tests;
  ends.pyramid_classifier.write_made([&] { return message; }, now, occupied - 1 + timing_.latency);
  ends.intersection_unit.pop(now);
  return occupied;
}

template class StageOf<ShadowUnit>;

}  // namespace pyrasim::hw
