// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cassert>
#include <cstddef>
#include <new>
#include <vector>

#include "hw_model/cycle.h"
#include "hw_model/fifo/fifo_base.h"

namespace pyrasim::hw {

template <class Message>
class FifoReader;
template <class Message>
class FifoWriter;

/// One writer, one reader. A token written at t with a latency of l >= 1 cycles can be read from t + l; a cell that is
/// read at t can be written again from t + 1. Its cells carry dates, so that writer and reader need not run at the same
/// time.
///
/// The functions here read or write a single token; FifoReader and FifoWriter are for many in a row.
template <class Message>
class Fifo final : public FifoBase {
 public:
  Fifo(const char* name, std::size_t depth) : FifoBase(name, depth), cells_(depth) {}

  /// The date from which the next token can be read; `never` while there is none.
  Cycle token_at() const { return empty() ? never : place_.next->visible; }
  /// The date from which the next cell can be written; `never` while all cells hold tokens whose read is not known yet.
  Cycle room_at() const { return full() ? never : write_->freed; }

  /// The next token. Its content is known as soon as it is written; only its date says when the reader may act on it.
  const Message& front() const {
    assert(!empty());
    return place_.next->message;
  }

  using FifoBase::statistics;
  FifoStatistics statistics(Cycle cycles) const override {
    FifoStatistics statistics = this->statistics();
    std::size_t max = tally_.max;
    const Cell* before = place_.before;
    const Cell* token = place_.next;
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

  /// Frees the cell of the next token, which has been looked at with front().
  void pop(Cycle now) {
    assert(!empty());
    if (events()) events().read(now);
    leave(place_, tally_, now);
    note_reads(1);
  }
  Message read(Cycle now) {
    const Message message = front();
    pop(now);
    return message;
  }
  void write(const Message& message, Cycle now, Cycle latency) {
    write_made([&] { return message; }, now, latency);
  }
  /// Writes the message that `make` returns, which is made in the cell itself: copying what has just been stored in
  /// pieces stalls a processor.
  template <class Make>
  void write_made(const Make& make, Cycle now, Cycle latency) {
    assert(latency >= 1 && now >= room_at());
    put(make, now, now + latency);
  }
  /// Puts in a token that is there when the frame begins.
  void preload(const Message& message) {
    put([&] { return message; }, 0, 0);
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

  struct Place {
    Cell* next;    ///< that is read
    Cell* before;  ///< of the token that lies tally_.max before that one
  };

  /// The token at `place` is read; on to the next.
  void leave(Place& place, Tally& tally, Cycle now) const {
    Cell& cell = *place.next;
    assert(now >= cell.visible);
    if (place.before->freed > cell.written) {  // that token was still there
      ++tally.max;
    } else {
      place.before = following(place.before);
    }
    cell.freed = now + 1;
    tally.token_cycles += cell.freed - cell.written;
    place.next = following(&cell);
  }
  /// A token is written into `cell`; on to the next.
  template <class Make>
  void fill(Cell*& cell, const Make& make, Cycle now, Cycle visible) const {
    ::new (static_cast<void*>(&cell->message)) Message(make());
    cell->written = now;
    cell->visible = visible;
    cell = following(cell);
  }
  template <class Make>
  void put(const Make& make, Cycle now, Cycle visible) {
    const Cell* cell = write_;
    fill(write_, make, now, visible);
    if (events()) events().write(now, visible, subject_of(cell->message));
    note_writes(1);
  }

  [[gnu::noinline]] void report_writes(std::size_t tokens) const {
    for (const Cell* cell = write_; tokens > 0; --tokens, cell = following(cell)) {
      events().write(cell->written, cell->visible, subject_of(cell->message));
    }
  }
  [[gnu::noinline]] void report_reads(std::size_t tokens) const {
    for (const Cell* cell = place_.next; tokens > 0; --tokens, cell = following(cell)) events().read(cell->freed - 1);
  }

  template <class Pointer>
  Pointer following(Pointer cell) const {
    return cell == last_ ? Pointer{first_} : cell + 1;
  }

  std::vector<Cell> cells_;  ///< a ring
  Cell* first_ = &cells_.front();
  Cell* last_ = &cells_.back();
  Cell* write_ = first_;
  Place place_{first_, last_};
};

}  // namespace pyrasim::hw
