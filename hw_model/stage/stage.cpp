// SPDX-License-Identifier: Apache-2.0
#include "hw_model/stage/stage.h"

#include <string>

#include "hw_model/fifo/fifo_base.h"
#include "hw_model/stage/kernel_time.h"
#include "hw_model/stage/work_list.h"

namespace pyrasim::hw {

void Stage::attach(WorkList& work) {
  decoupled_ = true;
  if (!chooses_by_arrival()) enlist(work.stages());  // the engine asks the others when it is their turn
  sleep();                                           // it may have been told of preloaded tokens
}

void Stage::woken() {
  if (!decoupled_) woken_.notify(sc_core::SC_ZERO_TIME);
}

void Stage::book(const Start& start, Cycle cycles) {
  assert(cycles >= 1);
  StageState waited = StageState::idle;
  if (firings_ == 0) {  // before the first firing the frame has not begun here
    idle_ = start.at();
  } else if (start.at() > ready_) {
    book_wait(ready_, start);
    waited = start.cause()->starved ? StageState::starved : StageState::blocked;
  }
  if (events_) {
    const std::uint32_t cause = start.cause() == nullptr ? no_fifo : start.cause()->fifo.number();
    events_.firing(waited, cause, ready_, start.at(), start.at() + cycles);
  }
  book(1, start.at() + cycles);
}

StageStatistics Stage::statistics(Cycle cycles) const {
  assert(ready_ <= cycles);
  const Cycle busy = ready_ - idle_ - starved_ - blocked_;
  return {.busy = busy, .starved = starved_, .blocked = blocked_, .idle = idle_ + cycles - ready_, .firings = firings_};
}

void Stage::run_in_lockstep(const RunControl& control) {
  sc_core::sc_spawn([this, &control] { lockstep(control); }, (std::string(basename()) + "_process").c_str());
}

void Stage::lockstep(const RunControl& control) {
  constexpr unsigned steps_to_poll = 1024;
  Cycle now = 0;
  for (unsigned step = 1;; ++step) {
    if (step % steps_to_poll == 0) control.poll();
    sleep();
    const Start start = next_start();
    if (start.known() && start.at() > control.last) return;
    if (start.at() == now) {
      fire_next();
      continue;
    }
    if (!start.known()) {
      sc_core::wait(woken_);
    } else if (chooses_by_arrival()) {
      sc_core::wait(kernel_time(start.at() - now), woken_);
    } else {
      sc_core::wait(kernel_time(start.at() - now));
    }
    now = sc_core::sc_time_stamp().value();
  }
}

}  // namespace pyrasim::hw
