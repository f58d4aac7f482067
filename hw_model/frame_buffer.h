// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hw_model/fifo/fifo_port.h"
#include "hw_model/fifo/fifo_reader.h"
#include "hw_model/message.h"
#include "hw_model/plan/frame_setup.h"
#include "hw_model/stage/stage_of.h"
#include "image/image.h"
#include "render/parallel.h"

namespace pyrasim::hw {

/// Stores finished pixels, in whatever order they come.
class FrameBuffer final : public StageOf<FrameBuffer> {
 public:
  FifoPort<PixelMessage> tree_accumulator{"tree_accumulator"};

  /// It has no latency: nothing waits for what it stores.
  FrameBuffer(const sc_core::sc_module_name& name, const FrameSetup& frame);

  const Image& image() const { return image_; }
  std::size_t stored() const { return stored_; }  ///< pixels
  bool complete() const { return stored_ == image_.pixels().size(); }
  /// Tells the progress how many pixels are stored, as happens by itself after each row's worth.
  void report() const;

 private:
  friend StageOf;
  struct Plan {
    Start start;
  };
  struct Ends {
    FifoReader<PixelMessage> tree_accumulator;
  };
  Ends ends() const { return {FifoReader(*tree_accumulator)}; }
  static Plan next(const Ends& ends, Cycle ready) { return {Start(ready).needs_token(ends.tree_accumulator)}; }
  Cycle fire(Ends& ends, const Plan& plan);

  Cycle interval_;
  Image image_;
  std::size_t stored_ = 0;
  Progress progress_;
  std::size_t next_progress_;  ///< pixels
};

extern template class StageOf<FrameBuffer>;

}  // namespace pyrasim::hw
