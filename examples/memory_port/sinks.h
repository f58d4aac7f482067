// SPDX-License-Identifier: Apache-2.0
// Sinks of one's own: told what happens in the machine, with the cycle in which it does.
#pragma once

#include <algorithm>

#include "hw_model/fifo/fifo.h"
#include "hw_model/trace/event.h"
#include "memory_port.h"

/// Follows the FIFO in front of the frame buffer: what is read there is stored, and goes on to the memory's port.
class StoredPixels final : public pyrasim::hw::EventSink {
 public:
  /// `source`: the FIFO's place among the machine's.
  StoredPixels(std::size_t source, pyrasim::hw::Fifo<StoredPixel>& memory) : source_(source), memory_(memory) {}
  void take(const pyrasim::hw::Event& event) override {
    if (event.kind == pyrasim::hw::Event::Kind::read && event.source == source_) memory_.write({count_++}, event.at, 1);
  }

 private:
  std::size_t source_;
  pyrasim::hw::Fifo<StoredPixel>& memory_;
  std::uint64_t count_ = 0;
};

/// Follows a stage: the longest time in a row that it waited for input.
class LongestWait final : public pyrasim::hw::EventSink {
 public:
  /// `source`: the stage's place among the machine's.
  explicit LongestWait(std::size_t source) : source_(source) {}
  void take(const pyrasim::hw::Event& event) override {
    if (event.kind != pyrasim::hw::Event::Kind::firing || event.source != source_) return;
    if (event.waited == pyrasim::hw::StageState::starved) cycles_ = std::max(cycles_, event.at - event.since);
  }
  pyrasim::hw::Cycle cycles() const { return cycles_; }

 private:
  std::size_t source_;
  pyrasim::hw::Cycle cycles_ = 0;
};
