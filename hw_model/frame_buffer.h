// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hw_model/machine_spec.h"
#include "hw_model/message.h"
#include "hw_model/stage.h"
#include "image/image.h"
#include "render/parallel.h"

namespace pyrasim::hw {

/// Stores finished pixels, in whatever order they come.
class FrameBuffer final : public StageOf<FrameBuffer> {
 public:
  FifoPort<PixelMessage> tree_accumulator{"tree_accumulator"};

  FrameBuffer(const sc_core::sc_module_name& name, StageTiming timing, int columns, int rows, Progress progress);

  const Image& image() const { return image_; }
  std::size_t stored() const { return stored_; }  ///< pixels
  bool complete() const { return stored_ == image_.pixels().size(); }

 private:
  friend StageOf;
  struct Ends {
    FifoReader<PixelMessage> tree_accumulator;
  };
  Ends ends() { return {FifoReader(*tree_accumulator)}; }
  static Start next(Ends& ends, Cycle ready) { return Start(ready).needs_token(ends.tree_accumulator); }
  Cycle fire(Ends& ends, Cycle now);

  StageTiming timing_;
  Image image_;
  std::size_t stored_ = 0;
  Progress progress_;
  std::size_t next_progress_;  ///< pixels
};

extern template class StageOf<FrameBuffer>;

}  // namespace pyrasim::hw
