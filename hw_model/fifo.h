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

class FifoBase;

/// What a stage can wait for in a FIFO.
struct WaitCounter {
  const FifoBase& fifo;
  bool starved;      ///< a token; else room
  Cycle cycles = 0;  ///< spent waiting for it
};

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
    return {depth_, tokens_ == 0 ? 0 : max_, token_cycles_, tokens_, starved_.cycles, blocked_.cycles};
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
  /// Several observers may look on.
  void observe(FifoObserver& observer) { observers_.push_back(&observer); }
  void ignore(FifoObserver& observer) { std::erase(observers_, &observer); }

  const char* kind() const override { return "pyrasim::hw::Fifo"; }

 protected:
  bool observed() const { return !observers_.empty(); }
  void tell_of_write(Cycle at) const {
    for (FifoObserver* observer : observers_) observer->written(at);
  }
  void tell_of_read(Cycle at) const {
    for (FifoObserver* observer : observers_) observer->read(at);
  }

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

  std::size_t max_ = 1;  ///< most tokens at once, of those that have been read; 1 where there is none
  std::uint64_t token_cycles_ = 0;

 private:
  std::size_t depth_;
  std::size_t size_ = 0;            ///< tokens
  std::size_t wake_reader_at_ = 1;  ///< tokens
  std::uint64_t tokens_ = 0;        ///< that were read
  WaitCounter starved_{*this, true};
  WaitCounter blocked_{*this, false};
  FifoEnd* writer_ = nullptr;
  FifoEnd* reader_ = nullptr;
  std::vector<FifoObserver*> observers_;
};

template <class Message>
class FifoReader;
template <class Message>
class FifoWriter;

/// One writer, one reader. A token written at t with a latency of l >= 1 cycles can be read from t + l; a cell that is
/// read at t can be written again from t + 1.
///
/// The functions here read or write a single token; FifoReader and FifoWriter are for many in a row.
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
  void pop(Cycle now) { FifoReader<Message>(*this).pop(now); }
  Message read(Cycle now) { return FifoReader<Message>(*this).read(now); }

  /// Puts in a token that is there when the frame begins.
  void preload(const Message& message) {
    FifoWriter<Message>(*this).put([&] { return message; }, 0, 0);
  }
  void write(const Message& message, Cycle now, Cycle latency) {
    FifoWriter<Message>(*this).write(message, now, latency);
  }
  /// See FifoWriter.
  template <class Make>
  void write_made(const Make& make, Cycle now, Cycle latency) {
    FifoWriter<Message>(*this).write_made(make, now, latency);
  }

  using FifoBase::statistics;
  FifoStatistics statistics(Cycle cycles) const override {
    FifoStatistics statistics = this->statistics();
    std::size_t max = max_;
    const Cell* before = before_;
    const Cell* token = read_;
    for (std::size_t unread = 1; unread <= size(); ++unread, token = following(token)) {
      if (max < unread || before->freed > token->written) {
        ++max;
      } else {
        before = following(before);
      }
      statistics.max = max;
      statistics.token_cycles += cycles - token->written;
    }
    return statistics;
  }

 private:
  friend FifoReader<Message>;
  friend FifoWriter<Message>;

  struct Cell {
    Message message;
    Cycle written;
    Cycle visible;
    Cycle freed = 0;  ///< the cycle after that of its last read
  };

  [[gnu::noinline]] void tell_of_writes(std::size_t tokens) const {
    for (const Cell* cell = write_; tokens > 0; --tokens, cell = following(cell)) tell_of_write(cell->written);
  }
  [[gnu::noinline]] void tell_of_reads(std::size_t tokens) const {
    for (const Cell* cell = read_; tokens > 0; --tokens, cell = following(cell)) tell_of_read(cell->freed - 1);
  }

  template <class Pointer>
  Pointer following(Pointer cell) const {
    return cell == last_ ? Pointer{first_} : cell + 1;
  }

  std::vector<Cell> cells_;  ///< a ring
  Cell* first_ = &cells_.front();
  Cell* last_ = &cells_.back();
  Cell* write_ = first_;
  Cell* read_ = first_;
  Cell* before_ = last_;  ///< the cell of the token that lies max_ before the one that is read next
};

/// The reader's end of a FIFO while its stage fires: keeps at hand what every token changes, and gives it back to the
/// FIFO in the end, when the writer is told as well. Meanwhile nobody else uses the FIFO.
template <class Message>
class FifoReader {
 public:
  explicit FifoReader(Fifo<Message>& fifo)
      : fifo_(fifo),
        unread_(fifo.size()),
        read_(fifo.read_),
        before_(fifo.before_),
        max_(fifo.max_),
        token_cycles_(fifo.token_cycles_) {}
  FifoReader(const FifoReader&) = delete;
  FifoReader& operator=(const FifoReader&) = delete;
  ~FifoReader() {
    const std::size_t read = fifo_.size() - unread_;
    if (read == 0) return;
    if (fifo_.observed()) fifo_.tell_of_reads(read);
    fifo_.read_ = read_;
    fifo_.before_ = before_;
    fifo_.max_ = max_;
    fifo_.token_cycles_ = token_cycles_;
    fifo_.note_reads(read);
  }

  // As those of Fifo.
  bool empty() const { return unread_ == 0; }
  Cycle token() const { return empty() ? never : read_->visible; }
  const Message& front() const {
    assert(!empty());
    return read_->message;
  }
  Message read(Cycle now) {
    const Message message = front();
    pop(now);
    return message;
  }
  void pop(Cycle now) {
    assert(!empty() && now >= read_->visible);
    if (before_->freed > read_->written) {  // that token was still there
      ++max_;
    } else {
      before_ = fifo_.following(before_);
    }
    read_->freed = now + 1;
    token_cycles_ += read_->freed - read_->written;
    read_ = fifo_.following(read_);
    --unread_;
  }
  WaitCounter& starved() const { return fifo_.starved(); }

 private:
  using Cell = typename Fifo<Message>::Cell;

  Fifo<Message>& fifo_;
  std::size_t unread_;
  Cell* read_;
  Cell* before_;
  std::size_t max_;
  std::uint64_t token_cycles_;
};

/// The writer's end, likewise.
template <class Message>
class FifoWriter {
 public:
  explicit FifoWriter(Fifo<Message>& fifo) : fifo_(fifo), free_(fifo.depth() - fifo.size()), write_(fifo.write_) {}
  FifoWriter(const FifoWriter&) = delete;
  FifoWriter& operator=(const FifoWriter&) = delete;
  ~FifoWriter() {
    const std::size_t written = fifo_.depth() - free_ - fifo_.size();
    if (written == 0) return;
    if (fifo_.observed()) fifo_.tell_of_writes(written);
    fifo_.write_ = write_;
    fifo_.note_writes(written);
  }

  // As those of Fifo.
  Cycle room() const { return free_ == 0 ? never : write_->freed; }
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
  WaitCounter& blocked() const { return fifo_.blocked(); }

 private:
  friend Fifo<Message>;
  using Cell = typename Fifo<Message>::Cell;

  template <class Make>
  void put(const Make& make, Cycle now, Cycle visible) {
    ::new (static_cast<void*>(&write_->message)) Message(make());
    write_->written = now;
    write_->visible = visible;
    write_ = fifo_.following(write_);
    --free_;
  }

  Fifo<Message>& fifo_;
  std::size_t free_;
  Cell* write_;
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
