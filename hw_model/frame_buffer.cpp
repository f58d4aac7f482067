// SPDX-License-Identifier: Apache-2.0
#include "hw_model/frame_buffer.h"

namespace pyrasim::hw {

FrameBuffer::FrameBuffer(const sc_core::sc_module_name& name, const FrameSetup& frame)
    : StageOf(name),
      interval_(frame.spec.frame_buffer_interval),
      image_(frame.window.columns, frame.window.rows),
      progress_(frame.progress),
      next_progress_(progress_ ? static_cast<std::size_t>(frame.window.columns) : 0) {}

Cycle FrameBuffer::fire(Ends& ends, const Plan& plan) {
  const PixelMessage& message = ends.tree_accumulator.front();
  image_.pixels()[message.pixel] = message.color;
  ends.tree_accumulator.pop(plan.start.at());
  if (++stored_ == next_progress_) {  // a row's worth
    next_progress_ += static_cast<std::size_t>(image_.columns());
    report();
  }
  return interval_;
}

void FrameBuffer::report() const {
  if (progress_) progress_(static_cast<double>(stored_) / static_cast<double>(image_.pixels().size()));
}

template class StageOf<FrameBuffer>;

}  // namespace pyrasim::hw
