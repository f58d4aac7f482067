// SPDX-License-Identifier: Apache-2.0
#include "hw_model/tree_accumulator.h"

namespace pyrasim::hw {

TreeAccumulator::TreeAccumulator(const sc_core::sc_module_name& name, StageTiming timing, std::size_t slots,
                                 int max_level)
    : StageOf(name), timing_(timing), max_level_(max_level), trees_(slots) {}

bool TreeAccumulator::completes(const TerminalMessage& node) const {
  return node.level == 0 || trees_[node.tag.slot].completed_by(node.level, max_level_);
}

Start TreeAccumulator::next() {
  if (pyramid_classifier->empty()) return Start(never);
  Start start = Start(ready()).needs_token(pyramid_classifier);
  if (completes(pyramid_classifier->front())) start.needs_room(frame_buffer).needs_room(pixel_scan);
  return start;
}

void TreeAccumulator::fire(Cycle now) {
  const TerminalMessage& node = pyramid_classifier->front();
  if (node.level == 0) {
    finish(node.tag, single_node_result(node.color), now);
  } else {
    TraceTree& tree = trees_[node.tag.slot];
    tree.add_terminal_node(node.level, node.color, max_level_);
    if (tree.complete(max_level_)) {
      finish(node.tag, tree.result(max_level_), now);
      tree = {};
    }
  }
  pyramid_classifier->pop(now);
  occupy(now, timing_.interval);
}

void TreeAccumulator::finish(const PixelTag& tag, const glm::vec3& color, Cycle now) {
  frame_buffer->write_made([&] { return PixelMessage{tag.pixel, color}; }, now, timing_.latency);
  pixel_scan->write({tag.slot}, now, timing_.latency);
}

}  // namespace pyrasim::hw
