// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cassert>
#include <cstddef>

#include "hw_model/fifo/fifo.h"

namespace pyrasim::hw {

/// The reader's end of a FIFO while its stage fires: keeps at hand what every token changes, and gives it back to the
/// FIFO in the end, when the writer is told as well. Meanwhile nobody else uses the FIFO.
template <class Message>
class FifoReader {
 public:
  explicit FifoReader(Fifo<Message>& fifo)
      : fifo_(fifo), unread_(fifo.size()), place_(fifo.place_), tally_(fifo.tally_) {}
  FifoReader(const FifoReader&) = delete;
  FifoReader& operator=(const FifoReader&) = delete;
  ~FifoReader() {
    const std::size_t read = fifo_.size() - unread_;
    if (read == 0) return;
    if (fifo_.events()) fifo_.report_reads(read);
    fifo_.place_ = place_;
    fifo_.tally_ = tally_;
    fifo_.note_reads(read);
  }

  // As those of Fifo.
  bool empty() const { return unread_ == 0; }
  Cycle token_at() const { return empty() ? never : place_.next->visible; }
  const Message& front() const {
    assert(!empty());
    return place_.next->message;
  }
  Message read(Cycle now) {
    const Message message = front();
    pop(now);
    return message;
  }
  void pop(Cycle now) {
    assert(!empty());
    fifo_.leave(place_, tally_, now);
    --unread_;
  }
  WaitCounter& starved() const { return fifo_.starved(); }

 private:
  Fifo<Message>& fifo_;
  std::size_t unread_;
  typename Fifo<Message>::Place place_;
  typename Fifo<Message>::Tally tally_;
};

}  // namespace pyrasim::hw
