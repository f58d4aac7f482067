// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hw_model/cycle.h"
#include "hw_model/fifo/wait_counter.h"

namespace pyrasim::hw {

/// When a stage can fire next, and what decides it: the latest of its own readiness, its tokens and its cells.
class Start {
 public:
  explicit Start(Cycle ready) : at_(ready) {}

  /// The firing reads a token of `fifo`: of the FIFO, or its FifoReader.
  template <class Fifo>
  Start& needs_token(Fifo& fifo) {
    return wait_until(fifo.token_at(), fifo.starved());
  }
  /// The firing writes into `fifo`: the FIFO, or its FifoWriter.
  template <class Fifo>
  Start& needs_room(Fifo& fifo) {
    return wait_until(fifo.room_at(), fifo.blocked());
  }

  Cycle at() const { return at_; }
  bool known() const { return at_ != never; }
  /// For the token or cell that comes last; none where the stage's own readiness does.
  WaitCounter* cause() const { return cause_; }

 private:
  Start& wait_until(Cycle date, WaitCounter& wait) {
    if (date > at_) {
      at_ = date;
      cause_ = &wait;
    }
    return *this;
  }

  Cycle at_;
  WaitCounter* cause_ = nullptr;
};

}  // namespace pyrasim::hw
