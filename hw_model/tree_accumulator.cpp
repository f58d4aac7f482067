// SPDX-License-Identifier: Apache-2.0
#include "hw_model/tree_accumulator.h"

#include <algorithm>

namespace pyrasim::hw {

TreeAccumulator::TreeAccumulator(const sc_core::sc_module_name& name, StageTiming timing, std::size_t slots,
                                 int max_level)
    : StageOf(name), timing_(timing), max_level_(max_level), slots_(slots) {}

bool TreeAccumulator::completes(const TerminalMessage& node) const {
  return node.level == 0 || slots_[node.tag.slot].tree.completed_by(node.level, max_level_);
}

Start TreeAccumulator::next() {
  Start start = Start(ready()).needs_token(pyramid_classifier);
  if (!pyramid_classifier->empty() && completes(pyramid_classifier->front()))
    start.needs_room(frame_buffer).needs_room(pixel_scan);
  return start;
}

void TreeAccumulator::fire(Cycle now) {
  const TerminalMessage& node = pyramid_classifier->front();
  if (node.level == 0) {
    finish(node.tag, 0, single_node_result(node.color), now);
  } else {
    auto& [tree, deepest] = slots_[node.tag.slot];
    tree.add_terminal_node(node.level, node.color, max_level_);
    deepest = std::max(deepest, node.level);
    if (tree.complete(max_level_)) {
      finish(node.tag, deepest, tree.result(max_level_), now);
      tree = {};
      deepest = 0;
    }
  }
  pyramid_classifier->pop(now);
  occupy(now, timing_.interval);
}

void TreeAccumulator::finish(const PixelTag& tag, std::uint32_t deepest, const glm::vec3& color, Cycle now) {
  latencies_[deepest].add(now + timing_.latency - tag.admitted);
  frame_buffer->write_made([&] { return PixelMessage{tag.pixel, color}; }, now, timing_.latency);
  pixel_scan->write({tag.slot}, now, timing_.latency);
}

template class StageOf<TreeAccumulator>;

}  // namespace pyrasim::hw
