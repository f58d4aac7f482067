// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "hw_model/fifo/fifo_port.h"
#include "hw_model/fifo/fifo_reader.h"
#include "hw_model/fifo/fifo_writer.h"
#include "hw_model/latency_histogram.h"
#include "hw_model/message.h"
#include "hw_model/plan/frame_setup.h"
#include "hw_model/slowest_pixels.h"
#include "hw_model/stage/stage_of.h"
#include "pyramid/trace_tree.h"

namespace pyrasim::hw {

/// Sums the trace trees of the pixels in flight, one slot for each. A pixel whose nodes cover its area goes to the
/// frame buffer, and its slot back to the pixel scan.
class TreeAccumulator final : public StageOf<TreeAccumulator> {
 public:
  FifoPort<ColorMessage> color_unit{"color_unit"};
  FifoPort<PixelMessage> frame_buffer{"frame_buffer"};
  FifoPort<SlotCredit> pixel_scan{"pixel_scan"};

  TreeAccumulator(const sc_core::sc_module_name& name, const FrameSetup& frame);

  /// Cycles from the scan's sending of a pixel's last corner to its colour being visible to the frame buffer; by the
  /// deepest level of the pixel's trace tree.
  using LatencyByLevel = std::array<LatencyHistogram, max_level_limit + 1>;
  const LatencyByLevel& latencies() const { return latencies_; }
  const SlowestPixels& slowest() const { return slowest_; }

 private:
  friend StageOf;
  struct Plan {
    Start start;
  };
  struct Ends {
    FifoReader<ColorMessage> color_unit;
    FifoWriter<PixelMessage> frame_buffer;
    FifoWriter<SlotCredit> pixel_scan;
  };
  Ends ends() const { return {FifoReader(*color_unit), FifoWriter(*frame_buffer), FifoWriter(*pixel_scan)}; }
  Plan next(const Ends& ends, Cycle ready) const;
  Cycle fire(Ends& ends, const Plan& plan);
  /// The whole tree of a pixel of case 1 or 2.
  bool is_pixel(const ColorMessage& node) const { return node.log2_side == static_cast<std::uint32_t>(max_level_); }
  bool completes(const ColorMessage& node) const;
  void finish(const PixelTag& tag, std::uint32_t deepest, const glm::vec3& color, Ends& ends, Cycle now);

  StageTiming timing_;
  int max_level_;
  std::vector<TraceTree> slots_;
  LatencyByLevel latencies_;
  SlowestPixels slowest_;
  CostMaps* maps_;  ///< or null
};

extern template class StageOf<TreeAccumulator>;

}  // namespace pyrasim::hw
