// SPDX-License-Identifier: Apache-2.0
// The machine's stages, a line each: elaboration, the report of what was not built and the names of FIFOs follow.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <tuple>

#include "hw_model/color_unit.h"
#include "hw_model/frame_buffer.h"
#include "hw_model/intersection_unit.h"
#include "hw_model/pixel_scan.h"
#include "hw_model/plan/frame_setup.h"
#include "hw_model/plan/need.h"
#include "hw_model/pyramid_classifier.h"
#include "hw_model/shadow_unit.h"
#include "hw_model/subdivision_controller.h"
#include "hw_model/tree_accumulator.h"
#include "hw_model/view_vector_generator.h"
#include "text/counted.h"

namespace pyrasim::hw {

inline Need always_built(const FrameSetup&) { return {true, "every frame needs it"}; }
inline Need where_pixels_are_subdivided(const FrameSetup& frame) {
  if (frame.options.max_level == 0) return {false, "MAX_LEVEL is 0: nothing is subdivided"};
  if (frame.scene.objects.empty()) return {false, "the scene has no objects: nothing is subdivided"};
  return {true, fmt::format("MAX_LEVEL is {}: pixels are subdivided", frame.options.max_level)};
}

inline Need where_lights_have_shadows(const FrameSetup& frame) {
  const std::size_t lights = frame.intersector.contents().lights_with_shadows;
  if (lights == 0) return {false, "the scene has no light with shadows, or nothing that casts one"};
  return {true, fmt::format("{} of the scene {} shadows", counted(lights, "light"), of_number(lights, "has", "have"))};
}

/// A stage of the machine; it is made from its module's name and a FrameSetup.
template <class Stage>
struct StagePlan {
  std::string_view name;
  Need (*need)(const FrameSetup& frame) = always_built;
  /// The setting that says how many stand side by side, numbered from 0; none: one, without a number.
  std::size_t MachineSpec::*copies = nullptr;
};

/// In data-flow order.
inline constexpr std::tuple stage_list{
    StagePlan<PixelScan>{"pixel_scan"},
    StagePlan<ViewVectorGenerator>{"view_vector_generator"},
    StagePlan<IntersectionUnit>{"intersection_unit", always_built, &MachineSpec::intersection_units},
    StagePlan<ShadowUnit>{"shadow_unit", where_lights_have_shadows, &MachineSpec::intersection_units},
    StagePlan<PyramidClassifier>{"pyramid_classifier"},
    StagePlan<SubdivisionController>{"subdivision_controller", where_pixels_are_subdivided},
    StagePlan<ColorUnit>{"color_unit"},
    StagePlan<TreeAccumulator>{"tree_accumulator"},
    StagePlan<FrameBuffer>{"frame_buffer"},
};

/// visit(plan) for every stage.
template <class Visit>
void for_each_stage(const Visit& visit) {
  std::apply([&](const auto&... stage) { (visit(stage), ...); }, stage_list);
}

template <class Stage>
inline constexpr const StagePlan<Stage>& plan_of = std::get<StagePlan<Stage>>(stage_list);

/// The name of a stage's box, in which all its copies are.
template <class Stage>
std::string box_of() {
  const auto& [name, need, copies] = plan_of<Stage>;
  return std::string(name) + (copies == nullptr ? "" : "s");
}

/// The name of a stage, or of the one of its copies that is numbered `number`.
template <class Stage>
std::string name_of(std::size_t number) {
  const auto& [name, need, copies] = plan_of<Stage>;
  return copies == nullptr ? std::string(name) : fmt::format("{}_{}", name, number);
}

}  // namespace pyrasim::hw
