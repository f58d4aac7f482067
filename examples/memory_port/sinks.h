// SPDX-License-Identifier: Apache-2.0
// Sinks of one's own: told what happens in the machine, with the cycle in which it does.
#pragma once

#include <algorithm>

#include "hw_model/fifo/fifo.h"
#include "hw_model/stage/stage_observer.h"
#include "memory_port.h"

/// Follows the FIFO in front of the frame buffer: what is read there is stored, and goes on to the memory's port.
class StoredPixels final : public pyrasim::hw::FifoObserver {
 public:
  explicit StoredPixels(pyrasim::hw::Fifo<StoredPixel>& memory) : memory_(memory) {}
  void written(pyrasim::hw::Cycle) override {}
  void read(pyrasim::hw::Cycle at) override { memory_.write({count_++}, at, 1); }

 private:
  pyrasim::hw::Fifo<StoredPixel>& memory_;
  std::uint64_t count_ = 0;
};

/// Follows a stage: the longest time in a row that it waited for input.
class LongestWait final : public pyrasim::hw::StageObserver {
 public:
  void span(State state, pyrasim::hw::Cycle from, pyrasim::hw::Cycle to) override {
    if (state == State::starved) cycles_ = std::max(cycles_, to - from);
  }
  pyrasim::hw::Cycle cycles() const { return cycles_; }

 private:
  pyrasim::hw::Cycle cycles_ = 0;
};
