// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "hw_model/machine_spec.h"
#include "hw_model/message.h"
#include "hw_model/stage.h"
#include "pyramid/trace_tree.h"

namespace pyrasim::hw {

/// Sums the trace trees of the pixels in flight, one slot for each. A pixel whose nodes cover its area goes to the
/// frame buffer, and its slot back to the pixel scan.
class TreeAccumulator final : public StageOf<TreeAccumulator> {
 public:
  FifoPort<TerminalMessage> pyramid_classifier{"pyramid_classifier"};
  FifoPort<PixelMessage> frame_buffer{"frame_buffer"};
  FifoPort<SlotCredit> pixel_scan{"pixel_scan"};

  TreeAccumulator(const sc_core::sc_module_name& name, StageTiming timing, std::size_t slots, int max_level);

  Start next() override;
  void fire(Cycle now) override;

 private:
  bool completes(const TerminalMessage& node) const;
  void finish(const PixelTag& tag, const glm::vec3& color, Cycle now);

  StageTiming timing_;
  int max_level_;
  std::vector<TraceTree> trees_;  ///< by slot
};

}  // namespace pyrasim::hw
