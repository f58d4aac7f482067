// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hw_model/fifo/fifo_port.h"
#include "hw_model/fifo/fifo_reader.h"
#include "hw_model/fifo/fifo_writer.h"
#include "hw_model/message.h"
#include "hw_model/plan/frame_setup.h"
#include "hw_model/stage/stage_of.h"
#include "scene/scene.h"

namespace pyrasim::hw {

/// Walks the (N_y + 1) x (N_z + 1) corners of the window's pixels (of the screen's, without one) in raster order. A
/// corner that completes a pixel (its lower right one) takes a free slot of the tree accumulator first: so many pixels
/// are in flight at most.
class PixelScan final : public StageOf<PixelScan> {
 public:
  FifoPort<SlotCredit> tree_accumulator{"tree_accumulator"};
  FifoPort<CornerRequest> view_vector_generator{"view_vector_generator"};

  PixelScan(const sc_core::sc_module_name& name, const FrameSetup& frame);

 private:
  friend StageOf;
  struct Plan {
    Start start;
  };
  struct Ends {
    FifoReader<SlotCredit> tree_accumulator;
    FifoWriter<CornerRequest> view_vector_generator;
  };
  Ends ends() const { return {FifoReader(*tree_accumulator), FifoWriter(*view_vector_generator)}; }
  Plan next(const Ends& ends, Cycle ready) const;
  Cycle fire(Ends& ends, const Plan& plan);
  bool completes_pixel() const { return row_ > 0 && column_ > 0; }

  StageTiming timing_;
  PixelWindow window_;
  std::uint32_t rows_;  ///< of the window, as are the others
  std::uint32_t columns_;
  int max_level_;
  std::uint32_t row_ = 0;  ///< of corners, 0 to rows_
  std::uint32_t column_ = 0;
  std::uint32_t pixel_ = 0;  ///< that is completed next
};

extern template class StageOf<PixelScan>;

}  // namespace pyrasim::hw
