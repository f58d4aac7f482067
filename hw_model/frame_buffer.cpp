// SPDX-License-Identifier: Apache-2.0
#include "hw_model/frame_buffer.h"

#include <utility>

namespace pyrasim::hw {

FrameBuffer::FrameBuffer(const sc_core::sc_module_name& name, StageTiming timing, int columns, int rows,
                         Progress progress)
    : StageOf(name), timing_(timing), image_(columns, rows), progress_(std::move(progress)) {}

void FrameBuffer::fire(Cycle now) {
  const PixelMessage message = tree_accumulator->read(now);
  image_.pixels()[message.pixel] = message.color;
  ++stored_;
  if (progress_ && stored_ % static_cast<std::size_t>(image_.columns()) == 0) {
    progress_(static_cast<double>(stored_) / static_cast<double>(image_.pixels().size()));
  }
  occupy(now, timing_.interval);
}

}  // namespace pyrasim::hw
