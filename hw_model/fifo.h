// SPDX-License-Identifier: Apache-2.0
// The bounded FIFO between two stages. Its cells carry dates, so that writer and reader need not run at the same time.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <new>
#include <systemc>
#include <vector>

#include "hw_model/cycle.h"

namespace pyrasim::hw {

/// One end of a FIFO: told when what it may be waiting for has happened. It is told once, until it falls asleep again.
class FifoEnd {
 public:
  virtual ~FifoEnd() = default;
  void wake() {
    if (awake_) return;
    awake_ = true;
    woken();
  }
  void sleep() { awake_ = false; }
  bool awake() const { return awake_; }

 protected:
  virtual void woken() = 0;

 private:
  bool awake_ = false;
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
  FifoBase(const char* name, std::size_t depth) : sc_prim_channel(name) {
    assert(depth >= 1);
    statistics_.depth = depth;
  }

  /// Of the tokens that have been read so far.
  const FifoStatistics& statistics() const { return statistics_; }
  /// Of a frame of `cycles` cycles that is over: with the tokens that nobody read.
  virtual FifoStatistics statistics(Cycle cycles) const = 0;
  void count_starved(Cycle cycles) { statistics_.starved += cycles; }
  void count_blocked(Cycle cycles) { statistics_.blocked += cycles; }
  void connect(FifoEnd& writer, FifoEnd& reader) {
    writer_ = &writer;
    reader_ = &reader;
  }
  /// The reader is told of a token only when it fills the FIFO. For a reader that can wait: it then reads many at once.
  void wake_reader_when_full() { wake_reader_at_ = statistics_.depth; }
  /// Several observers may look on.
  void observe(FifoObserver& observer) {
    observers_.push_back(&observer);
    observed_ = true;
  }
  void ignore(FifoObserver& observer) {
    std::erase(observers_, &observer);
    observed_ = !observers_.empty();
  }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  bool full() const { return size_ == statistics_.depth; }

  const char* kind() const override { return "pyrasim::hw::Fifo"; }

 protected:
  void note_write(Cycle now) {
    ++size_;
    if (observed_) {
      for (FifoObserver* observer : observers_) observer->written(now);
    }
    if (size_ == wake_reader_at_ && reader_ != nullptr) reader_->wake();
  }

  void note_read(Cycle now, Cycle written_at) {
    statistics_.token_cycles += now + 1 - written_at;
    ++statistics_.tokens;
    const bool was_full = full();
    --size_;
    if (observed_) {
      for (FifoObserver* observer : observers_) observer->read(now);
    }
    if (was_full && writer_ != nullptr) writer_->wake();
  }

  void note_size(std::size_t tokens) { statistics_.max = std::max(statistics_.max, tokens); }

 private:
  FifoStatistics statistics_;
  std::size_t size_ = 0;            ///< tokens
  std::size_t wake_reader_at_ = 1;  ///< tokens
  FifoEnd* writer_ = nullptr;
  FifoEnd* reader_ = nullptr;
  bool observed_ = false;
  std::vector<FifoObserver*> observers_;
};

/// One writer, one reader. A token written at t with a latency of l >= 1 cycles can be read from t + l; a cell that is
/// read at t can be written again from t + 1.
template <class Message>
class Fifo final : public FifoBase {
 public:
  Fifo(const char* name, std::size_t depth) : FifoBase(name, depth), cells_(depth) {}

  /// The date from which the next token can be read; `never` while there is none.
  Cycle token() const { return empty() ? never : read_->visible; }
  /// The date from which the next cell can be written; `never` while all cells hold tokens whose read is not known yet.
  Cycle room() const { return full() ? never : write_->freed; }

  /// The next token. Its content is known as soon as it is written; only its date says when the reader may act on it.
  const Message& front() const {
    assert(!empty());
    return read_->message;
  }

  /// Frees the cell of the next token, which has been looked at with front().
  void pop(Cycle now) {
    assert(!empty() && now >= read_->visible);
    if (statistics().max < statistics().depth) note_size_at(read_->written);
    const Cycle written = read_->written;
    read_->freed = now + 1;
    read_ = following(read_);
    note_read(now, written);
  }

  Message read(Cycle now) {
    const Message message = front();
    pop(now);
    return message;
  }

  /// Puts in a token that is there when the frame begins.
  void preload(const Message& message) {
    put([&] { return message; }, 0, 0);
  }

  void write(const Message& message, Cycle now, Cycle latency) {
    write_made([&] { return message; }, now, latency);
  }
  /// Writes the message that `make` returns, which is made in the cell itself: copying what has just been stored in
  /// pieces stalls a processor.
  template <class Make>
  void write_made(const Make& make, Cycle now, Cycle latency) {
    assert(latency >= 1 && now >= room());
    put(make, now, now + latency);
  }

  using FifoBase::statistics;
  FifoStatistics statistics(Cycle cycles) const override {
    const auto following = [&](const Cell* cell) { return cell == last_ ? cells_.data() : cell + 1; };
    FifoStatistics statistics = this->statistics();
    const Cell* oldest = oldest_;
    std::size_t shared = shared_;
    const Cell* token = read_;
    for (std::size_t unread = 1; unread <= size(); ++unread, token = following(token)) {
      for (; shared > 0 && oldest->freed <= token->written; --shared) oldest = following(oldest);
      statistics.max = std::max(statistics.max, std::min(shared + unread, statistics.depth));
      statistics.token_cycles += cycles - token->written;
    }
    return statistics;
  }

 private:
  struct Cell {
    Message message;
    Cycle written;
    Cycle visible;
    Cycle freed = 0;  ///< the cycle after that of its last read
  };

  template <class Make>
  void put(const Make& make, Cycle now, Cycle visible) {
    ::new (static_cast<void*>(&write_->message)) Message(make());
    write_->written = now;
    write_->visible = visible;
    write_ = following(write_);
    note_write(now);
  }

  /// Takes note of how many tokens were in the FIFO when the one that is read next was written.
  void note_size_at(Cycle written) {
    for (; shared_ > 0 && oldest_->freed <= written; --shared_) oldest_ = following(oldest_);
    note_size(++shared_);
  }

  Cell* following(Cell* cell) { return cell == last_ ? cells_.data() : cell + 1; }

  std::vector<Cell> cells_;  ///< a ring
  Cell* last_ = &cells_.back();
  Cell* write_ = cells_.data();
  Cell* read_ = cells_.data();
  /// Until `max` is the depth: the first cell whose token was still there when the last token read was written, and how
  /// many tokens from there on have been read.
  Cell* oldest_ = cells_.data();
  std::size_t shared_ = 0;
};

/// A stage's port to one of its FIFOs; `Policy` as for sc_port. It is bound to the channel itself, once.
template <class Message, sc_core::sc_port_policy Policy = sc_core::SC_ONE_OR_MORE_BOUND>
class FifoPort : public sc_core::sc_port<Fifo<Message>, 1, Policy> {
 public:
  using sc_core::sc_port<Fifo<Message>, 1, Policy>::sc_port;

  void operator()(Fifo<Message>& fifo) {
    sc_core::sc_port<Fifo<Message>, 1, Policy>::operator()(fifo);
    fifo_ = &fifo;
  }
  bool bound() const { return fifo_ != nullptr; }
  Fifo<Message>& operator*() const { return *fifo_; }
  Fifo<Message>* operator->() const { return fifo_; }

 private:
  Fifo<Message>* fifo_ = nullptr;
};

/// A port that stays unbound where the stage at its other end is not built.
template <class Message>
using OptionalFifoPort = FifoPort<Message, sc_core::SC_ZERO_OR_MORE_BOUND>;

}  // namespace pyrasim::hw
