// SPDX-License-Identifier: Apache-2.0
#include "hw_model/color_unit.h"

namespace pyrasim::hw {

ColorUnit::ColorUnit(const sc_core::sc_module_name& name, const FrameSetup& frame)
    : StageOf(name),
      timing_(frame.spec.color_unit),
      palette_(frame.scene, std::int64_t{1} << frame.options.max_level, frame.options.texture),
      edge_policy_(frame.options.edge) {}

Cycle ColorUnit::fire(Ends& ends, const Plan& plan) {
  const Cycle now = plan.start.at();
  const TerminalMessage& node = ends.pyramid_classifier.front();
  ends.tree_accumulator.write_made(
      [&] {
        return ColorMessage{palette_.terminal_color(node.which, node.corners, edge_policy_, node.cell), node.tag,
                            node.cell.log2_side};
      },
      now, timing_.latency);
  ends.pyramid_classifier.pop(now);
  return timing_.interval;
}

template class StageOf<ColorUnit>;

}  // namespace pyrasim::hw
