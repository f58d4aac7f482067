// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <random>

#include "hw_model/machine_spec.h"
#include "hw_model/plan/wire_list.h"

namespace pyrasim::hw {

/// Any machine that holds the trees of `max_level`; small numbers are more frequent than large ones.
inline MachineSpec random_machine(std::mt19937_64& random, int max_level) {
  const auto from = [&](std::uint64_t low, std::uint64_t high) { return low + random() % (high - low + 1); };
  const auto timing = [&] { return StageTiming{from(1, from(1, 64)), from(1, from(1, 8))}; };
  const auto depth = [&] { return static_cast<std::size_t>(from(1, from(1, 64))); };
  MachineSpec spec;
  spec.clock_mhz = std::uniform_real_distribution<double>(1, 2000)(random);
  spec.pixel_scan = timing();
  spec.view_vector_generator = timing();
  spec.intersection_units = from(1, 16);
  spec.dispatch = random() % 2 == 0 ? Dispatch::round_robin : Dispatch::first_free;
  spec.issue_order_queue = depth();
  spec.intersection_latency = from(1, 64);
  spec.intersection_cost = {from(1, 8), from(0, 4)};
  for (Cycle& cost : spec.intersection_cost.surface_test) cost = from(0, 8);
  spec.shadow_unit = {from(1, 64), from(0, 8)};
  spec.pyramid_classifier = timing();
  spec.subdivision_controller = timing();
  spec.subdivision_pool = required_pool(max_level) + from(0, from(0, 40));
  spec.color_unit = timing();
  spec.texture_cost = {from(0, 8), from(0, 4), from(0, 4)};
  spec.tree_accumulator = timing();
  spec.pixels_in_flight = from(1, from(1, 300));
  spec.frame_buffer_interval = timing().interval;
  for_each_wire([&](const auto& wire) {
    if (wire.depth != nullptr) spec.fifos.*wire.depth = depth();
  });
  return spec;
}

}  // namespace pyrasim::hw
