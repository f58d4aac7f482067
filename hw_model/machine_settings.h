// SPDX-License-Identifier: Apache-2.0
// The settings of a machine as one list: reading a machine file, writing one, and comparing two machines walk over it.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "hw_model/machine_spec.h"
#include "hw_model/plan/wire_list.h"
#include "json/json_reader.h"

namespace pyrasim::hw {

/// visit(path, setting, allowed) for every setting but the name. `path` is that of --set, "intersection.cost.ray";
/// `allowed` is an IntegerRange for Cycle and std::size_t, a NumberRange for double, and the names for an enumeration.
/// Spec: MachineSpec, or const. A new setting is a line here (the depth of a FIFO: in plan/wire_list.h), one in
/// machine_spec.h and one in the schema.
template <class Spec, class Visit>
void for_each_setting(Spec& spec, const Visit& visit) {
  constexpr IntegerRange cycles{1, 1'000'000};
  constexpr IntegerRange cost{0, 1'000'000};
  constexpr IntegerRange depth{1, 65'536};
  constexpr NumberRange positive{0.001, 1e6};
  const auto stage = [&](const std::string& name, auto& timing) {
    visit(name + ".latency", timing.latency, cycles);
    visit(name + ".interval", timing.interval, cycles);
  };
  visit("clock_mhz", spec.clock_mhz, positive);
  visit("goal_fps", spec.goal_fps, positive);
  stage("pixel_scan", spec.pixel_scan);
  stage("view_vector_generator", spec.view_vector_generator);
  visit("intersection.units", spec.intersection_units, IntegerRange{1, 256});
  visit("intersection.dispatch", spec.dispatch, dispatch_names);
  visit("intersection.issue_order_queue", spec.issue_order_queue, depth);
  visit("intersection.latency", spec.intersection_latency, cycles);
  visit("intersection.cost.ray", spec.intersection_cost.ray, cycles);
  visit("intersection.cost.box_test", spec.intersection_cost.box_test, cost);
  for (std::size_t kind = 0; kind < surface_kinds; ++kind) {
    visit("intersection.cost." + std::string(surface_traits[kind].name), spec.intersection_cost.surface_test[kind],
          cost);
  }
  visit("shadow_unit.latency", spec.shadow_unit.latency, cycles);
  visit("shadow_unit.cost.ray", spec.shadow_unit.ray, cost);
  stage("pyramid_classifier", spec.pyramid_classifier);
  visit("pyramid_classifier.line_buffer", spec.line_buffer, IntegerRange{3, 65'537});
  stage("subdivision_controller", spec.subdivision_controller);
  visit("subdivision_controller.pool", spec.subdivision_pool, IntegerRange{0, 1'000'000});
  stage("color_unit", spec.color_unit);
  visit("color_unit.cost.place", spec.texture_cost.place, cost);
  visit("color_unit.cost.line", spec.texture_cost.line, cost);
  visit("color_unit.cost.texel", spec.texture_cost.texel, cost);
  stage("tree_accumulator", spec.tree_accumulator);
  visit("tree_accumulator.pixels", spec.pixels_in_flight, IntegerRange{1, 1'000'000});
  visit("frame_buffer.interval", spec.frame_buffer_interval, cycles);
  for_each_wire([&](const auto& wire) {
    if (wire.depth != nullptr) visit("fifos." + name_of(wire), spec.fifos.*wire.depth, depth);
  });
}

/// A machine file that says every setting: {"clock_mhz": 200, "intersection": {"units": 4, ...}, ...}, the name left
/// out.
nlohmann::ordered_json settings_document(const MachineSpec& spec);

/// SHA-256 of that document's text without blanks, in hexadecimal: equal for machines that are alike but for their
/// names.
std::string settings_sha256(const MachineSpec& spec);

}  // namespace pyrasim::hw
