// SPDX-License-Identifier: Apache-2.0
#include "machines.h"

#include "hw_model/plan/wire_list.h"

namespace pyrasim::hw {

MachineSpec quick_machine() {
  MachineSpec spec;
  spec.view_vector_generator.latency = 1;
  spec.intersection_units = 1;
  spec.intersection_latency = 1;
  spec.intersection_cost = {1, 0, {0, 0, 0}};
  spec.pyramid_classifier.latency = 1;
  spec.subdivision_controller.latency = 1;
  spec.tree_accumulator.latency = 1;
  return spec;
}

MachineSpec with_all_fifos(MachineSpec spec, std::size_t depth) {
  for_each_wire([&](const auto& wire) {
    if (wire.depth != nullptr) spec.fifos.*wire.depth = depth;
  });
  return spec;
}

}  // namespace pyrasim::hw
