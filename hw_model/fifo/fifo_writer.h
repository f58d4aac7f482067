// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cassert>
#include <cstddef>

#include "hw_model/fifo/fifo.h"

namespace pyrasim::hw {

/// The writer's end of a FIFO while its stage fires; see FifoReader.
template <class Message>
class FifoWriter {
 public:
  explicit FifoWriter(Fifo<Message>& fifo) : fifo_(fifo), free_(fifo.depth() - fifo.size()), write_(fifo.write_) {}
  FifoWriter(const FifoWriter&) = delete;
  FifoWriter& operator=(const FifoWriter&) = delete;
  ~FifoWriter() {
    const std::size_t written = fifo_.depth() - free_ - fifo_.size();
    if (written == 0) return;
    if (fifo_.events()) fifo_.report_writes(written);
    fifo_.write_ = write_;
    fifo_.note_writes(written);
  }

  // As those of Fifo.
  Cycle room_at() const { return free_ == 0 ? never : write_->freed; }
  void write(const Message& message, Cycle now, Cycle latency) {
    write_made([&] { return message; }, now, latency);
  }
  template <class Make>
  void write_made(const Make& make, Cycle now, Cycle latency) {
    assert(latency >= 1 && now >= room_at());
    fifo_.fill(write_, make, now, now + latency);
    --free_;
  }
  WaitCounter& blocked() const { return fifo_.blocked(); }

 private:
  Fifo<Message>& fifo_;
  std::size_t free_;
  typename Fifo<Message>::Cell* write_;
};

}  // namespace pyrasim::hw
