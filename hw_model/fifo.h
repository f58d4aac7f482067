// SPDX-License-Identifier: Apache-2.0
// The bounded FIFO between two stages. Its cells carry dates, so that writer and reader need not run at the same time.
#pragma once

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstddef>
#include <systemc>
#include <vector>

#include "hw_model/cycle.h"

namespace pyrasim::hw {

/// One end of a FIFO: told when what it may be waiting for has happened.
class FifoEnd {
 public:
  virtual ~FifoEnd() = default;
  virtual void wake() = 0;
};

/// Told of every write and read; dates ascend for each of the two.
class FifoObserver {
 public:
  virtual ~FifoObserver() = default;
  virtual void written(Cycle at) = 0;
  virtual void read(Cycle at) = 0;
};

/// What a FIFO's use amounted to. Tokens count from the cycle of their write to that of their read, both included.
struct FifoStatistics {
  std::size_t depth = 0;
  std::size_t max = 0;             ///< most tokens in it at once
  std::uint64_t token_cycles = 0;  ///< sum over tokens of the cycles spent in it; divided by the frame's: the mean
  std::uint64_t tokens = 0;        ///< that were read
  Cycle starved = 0;               ///< cycles that the reader waited for a token from here
  Cycle blocked = 0;               ///< cycles that the writer waited for room in here
};

/// Everything about a FIFO but its tokens.
class FifoBase : public sc_core::sc_prim_channel, public sc_core::sc_interface {
 public:
  FifoBase(const char* name, std::size_t depth)
      : sc_prim_channel(name), mask_(std::bit_ceil(depth) - 1), freed_(mask_ + 1) {
    assert(depth >= 1);
    statistics_.depth = depth;
  }

  /// Of the tokens that have been read so far.
  const FifoStatistics& statistics() const { return statistics_; }
  /// Of a frame of `cycles` cycles that is over: with the tokens that nobody read.
  FifoStatistics statistics(Cycle cycles) const {
    FifoStatistics statistics = statistics_;
    std::size_t unfreed = unfreed_;
    for (std::size_t token = read_; token < written_; ++token) {
      const Cycle written_at = written(token & mask_);
      while (unfreed < read_ && freed_[unfreed & mask_] <= written_at) ++unfreed;
      statistics.max = std::max(statistics.max, token - unfreed + 1);
      statistics.token_cycles += cycles - written_at;
    }
    return statistics;
  }
  void count_starved(Cycle cycles) { statistics_.starved += cycles; }
  void count_blocked(Cycle cycles) { statistics_.blocked += cycles; }
  void connect(FifoEnd& writer, FifoEnd& reader) {
    writer_ = &writer;
    reader_ = &reader;
  }
  void observe(FifoObserver* observer) { observer_ = observer; }

  std::size_t size() const { return written_ - read_; }
  bool empty() const { return written_ == read_; }

  /// The date from which the next cell can be written: a cell read at t is free at t + 1. `never` while all cells hold
  /// tokens whose read is not known yet.
  Cycle room() const { return size() == statistics_.depth ? never : freed_[(written_ - statistics_.depth) & mask_]; }

  const char* kind() const override { return "pyrasim::hw::Fifo"; }

 protected:
  void note_write(Cycle now) {
    const bool was_empty = empty();
    ++written_;
    if (observer_ != nullptr) observer_->written(now);
    if (was_empty && reader_ != nullptr) reader_->wake();
  }

  void note_read(Cycle now, Cycle written_at) {
    // Tokens that shared the FIFO with this one when it was written: those read later than that.
    while (unfreed_ < read_ && freed_[unfreed_ & mask_] <= written_at) ++unfreed_;
    statistics_.max = std::max(statistics_.max, read_ - unfreed_ + 1);
    statistics_.token_cycles += now + 1 - written_at;
    ++statistics_.tokens;
    const bool was_full = size() == statistics_.depth;
    freed_[read_ & mask_] = now + 1;
    ++read_;
    if (observer_ != nullptr) observer_->read(now);
    if (was_full && writer_ != nullptr) writer_->wake();
  }

  /// When the token in a cell was written.
  virtual Cycle written(std::size_t cell) const = 0;

  std::size_t mask() const { return mask_; }
  std::size_t next_write() const { return written_ & mask_; }
  std::size_t next_read() const { return read_ & mask_; }

 private:
  FifoStatistics statistics_;
  std::size_t mask_;          ///< of an index into the rings: a power of two, at least the depth, less 1
  std::size_t written_ = 0;   ///< tokens
  std::size_t read_ = 0;      ///< tokens
  std::size_t unfreed_ = 0;   ///< the first token whose cell was not yet free when the last token read was written
  std::vector<Cycle> freed_;  ///< ring: from when the cell of a token is free again
  FifoEnd* writer_ = nullptr;
  FifoEnd* reader_ = nullptr;
  FifoObserver* observer_ = nullptr;
};

/// One writer, one reader. A token written at t with a latency of l >= 1 cycles can be read from t + l.
template <class Message>
class Fifo final : public FifoBase {
 public:
  Fifo(const char* name, std::size_t depth) : FifoBase(name, depth), cells_(mask() + 1) {}

  /// The date from which the next token can be read; `never` while there is none.
  Cycle token() const { return empty() ? never : cells_[next_read()].visible; }

  /// The next token. Its content is known as soon as it is written; only its date says when the reader may act on it.
  const Message& front() const {
    assert(!empty());
    return cells_[next_read()].message;
  }

  Message read(Cycle now) {
    const Cell& cell = cells_[next_read()];
    assert(!empty() && now >= cell.visible);
    const Message message = cell.message;
    note_read(now, cell.written);
    return message;
  }

  /// Puts in a token that is there when the frame begins.
  void preload(const Message& message) {
    cells_[next_write()] = {message, 0, 0};
    note_write(0);
  }

  void write(const Message& message, Cycle now, Cycle latency) {
    assert(latency >= 1 && now >= room());
    cells_[next_write()] = {message, now, now + latency};
    note_write(now);
  }

 protected:
  Cycle written(std::size_t cell) const override { return cells_[cell].written; }

 private:
  struct Cell {
    Message message;
    Cycle written;
    Cycle visible;
  };
  std::vector<Cell> cells_;
};

template <class Message>
using FifoPort = sc_core::sc_port<Fifo<Message>>;

/// A port that stays unbound where the stage at its other end is not built.
template <class Message>
using OptionalFifoPort = sc_core::sc_port<Fifo<Message>, 1, sc_core::SC_ZERO_OR_MORE_BOUND>;

}  // namespace pyrasim::hw
