// SPDX-License-Identifier: Apache-2.0
#include "hw_model/color_unit.h"

#include <fmt/format.h>

#include <algorithm>

#include "hw_model/record/recorded_textures.h"
#include "text/counted.h"

namespace pyrasim::hw {
namespace {

std::size_t textured_objects(const Scene& scene) {
  return static_cast<std::size_t>(std::count_if(scene.objects.begin(), scene.objects.end(),
                                                [](const Object& object) { return object.texture != nullptr; }));
}

}  // namespace

ColorUnit::ColorUnit(const sc_core::sc_module_name& name, const FrameSetup& frame)
    : StageOf(name),
      timing_(frame.spec.color_unit),
      palette_(frame.scene, std::int64_t{1} << frame.options.max_level, frame.options.texture),
      edge_policy_(frame.options.edge),
      texture_cost_(frame.spec.texture_cost),
      recorded_textures_(frame.options.textures),
      textured_objects_(recorded_textures_ ? recorded_textures_->objects() : textured_objects(frame.scene)) {}

std::vector<StagePart> ColorUnit::parts() const {
  const std::size_t objects = textured_objects_;
  const Need need = objects == 0 ? Need{false, "the scene has no textures"}
                                 : Need{true, fmt::format("{} of the scene {} a texture", counted(objects, "object"),
                                                          of_number(objects, "has", "have"))};
  return {{"texture", need, cost_of(work_, texture_cost_)}};
}

inline FixedColor ColorUnit::color_of(const TerminalMessage& node, TextureWork& work) const {
  return palette_.terminal_color(node.which, node.corners, edge_policy_, node.cell, work);
}

[[gnu::noinline]] FixedColor ColorUnit::textured_color(const TerminalMessage& node, TextureWork& work) const {
  FixedColor color{};
  if (recorded_textures_) {
    work = recorded_textures_->work(node.cell);
  } else {
    color = color_of(node, work);
  }
  if (work_sink_ != nullptr) work_sink_->node(node.cell, work);
  return color;
}

Cycle ColorUnit::fire(Ends& ends, const Plan& plan) {
  const Cycle now = plan.start.at();
  const TerminalMessage& node = ends.pyramid_classifier.front();
  TextureWork work;
  const FixedColor color = textured_objects_ == 0 ? color_of(node, work) : textured_color(node, work);
  const Cycle cost = cost_of(work, texture_cost_);
  work_ += work;
  ends.tree_accumulator.write_made(
      [&] {
        return ColorMessage{color, node.tag, node.cell.log2_side};
      },
      now, cost + timing_.latency);
  ends.pyramid_classifier.pop(now);
  return timing_.interval + cost;
}

template class StageOf<ColorUnit>;

}  // namespace pyrasim::hw
