// SPDX-License-Identifier: Apache-2.0
#include "hw_model/tree_accumulator.h"

namespace pyrasim::hw {

TreeAccumulator::TreeAccumulator(const sc_core::sc_module_name& name, const FrameSetup& frame)
    : StageOf(name),
      timing_(frame.spec.tree_accumulator),
      max_level_(frame.options.max_level),
      slots_(frame.spec.pixels_in_flight),
      maps_(frame.options.maps) {}

bool TreeAccumulator::completes(const ColorMessage& node) const {
  return is_pixel(node) || slots_[node.tag.slot].completed_by(node.log2_side, max_level_);
}

TreeAccumulator::Plan TreeAccumulator::next(const Ends& ends, Cycle ready) const {
  Start start = Start(ready).needs_token(ends.color_unit);
  if (!start.known()) return {start};
  if (completes(ends.color_unit.front())) start.needs_room(ends.frame_buffer).needs_room(ends.pixel_scan);
  return {start};
}

Cycle TreeAccumulator::fire(Ends& ends, const Plan& plan) {
  const Cycle now = plan.start.at();
  const ColorMessage& node = ends.color_unit.front();
  if (is_pixel(node)) {
    finish(node.tag, 0, single_node_result(node.color), ends, now);
  } else {
    TraceTree& tree = slots_[node.tag.slot];
    tree.add_terminal_node(node.log2_side, node.color);
    if (tree.complete(max_level_)) {
      // Of an edge's four parts one is an edge, down to MAX_LEVEL: every tree that was split is as deep.
      finish(node.tag, static_cast<std::uint32_t>(max_level_), tree.result(max_level_), ends, now);
      tree = {};
    }
  }
  ends.color_unit.pop(now);
  return timing_.interval;
}

void TreeAccumulator::finish(const PixelTag& tag, std::uint32_t deepest, const glm::vec3& color, Ends& ends,
                             Cycle now) {
  const Cycle latency = now + timing_.latency - tag.admitted;
  latencies_[deepest].add(latency);
  slowest_.add({tag.pixel, deepest, latency});
  if (maps_ != nullptr) maps_->set_latency(tag.pixel, latency);
  ends.frame_buffer.write_made([&] { return PixelMessage{tag.pixel, color}; }, now, timing_.latency);
  ends.pixel_scan.write({tag.slot}, now, timing_.latency);
}

template class StageOf<TreeAccumulator>;

}  // namespace pyrasim::hw
