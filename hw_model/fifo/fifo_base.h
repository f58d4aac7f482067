// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <systemc>

#include "hw_model/cycle.h"
#include "hw_model/fifo/fifo_end.h"
#include "hw_model/fifo/fifo_statistics.h"
#include "hw_model/fifo/wait_counter.h"
#include "hw_model/trace/event_port.h"

namespace pyrasim::hw {

/// Everything about a FIFO but its tokens.
class FifoBase : public sc_core::sc_prim_channel, public sc_core::sc_interface {
 public:
  FifoBase(const char* name, std::size_t depth) : sc_prim_channel(name), depth_(depth) { assert(depth >= 1); }

  std::size_t depth() const { return depth_; }
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  bool full() const { return size_ == depth_; }

  /// Of the tokens that have been read so far.
  FifoStatistics statistics() const {
    return {depth_, tokens_ == 0 ? 0 : tally_.max, tally_.token_cycles, tokens_, starved_.cycles, blocked_.cycles};
  }
  /// Of a frame of `cycles` cycles that is over: with the tokens that nobody read.
  virtual FifoStatistics statistics(Cycle cycles) const = 0;
  WaitCounter& starved() { return starved_; }
  WaitCounter& blocked() { return blocked_; }

  void connect(FifoEnd& writer, FifoEnd& reader) {
    writer_ = &writer;
    reader_ = &reader;
  }
  /// The reader is told of a token only when it fills the FIFO. For a reader that can wait: it then reads many at once.
  void wake_reader_when_full() { wake_reader_at_ = depth_; }
  /// Every write and read from now on is an event.
  void report_to(const EventPort& events) { events_ = events; }
  /// Its place in Processor::fifos(), where it reports to somebody.
  std::uint32_t number() const { return events_.source(); }

  const char* kind() const override { return "pyrasim::hw::Fifo"; }

 protected:
  const EventPort& events() const { return events_; }

  /// Takes note that so many tokens have been written.
  void note_writes(std::size_t tokens) {
    const bool reached = size_ < wake_reader_at_ && size_ + tokens >= wake_reader_at_;
    size_ += tokens;
    if (reached && reader_ != nullptr) reader_->wake();
  }
  /// Takes note that so many tokens, at least one, have been read.
  void note_reads(std::size_t tokens) {
    const bool was_full = full();
    tokens_ += tokens;
    size_ -= tokens;
    if (was_full && writer_ != nullptr) writer_->wake();
  }

  /// Of the tokens that have been read.
  struct Tally {
    std::size_t max = 1;             ///< most at once; 1 where there is none
    std::uint64_t token_cycles = 0;  ///< as in FifoStatistics
  };
  Tally tally_;

 private:
  std::size_t depth_;
  std::size_t size_ = 0;            ///< tokens
  std::size_t wake_reader_at_ = 1;  ///< tokens
  std::uint64_t tokens_ = 0;        ///< that were read
  WaitCounter starved_{*this, true};
  WaitCounter blocked_{*this, false};
  FifoEnd* writer_ = nullptr;
  FifoEnd* reader_ = nullptr;
  EventPort events_;
};

}  // namespace pyrasim::hw
