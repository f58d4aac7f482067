// SPDX-License-Identifier: Apache-2.0
#include "hw_model/stage.h"

namespace pyrasim::hw {

void Stage::account_wait(const Start& start) {
  const Cycle waited = start.at() - ready_;
  StageObserver::State state = StageObserver::State::idle;  // before the first firing the frame has not begun here
  if (statistics_.firings == 0) {
    statistics_.idle += waited;
  } else if (start.starved()) {
    state = StageObserver::State::starved;
    statistics_.starved += waited;
    start.cause()->count_starved(waited);
  } else {
    state = StageObserver::State::blocked;
    statistics_.blocked += waited;
    start.cause()->count_blocked(waited);
  }
  if (observer_ != nullptr) observer_->span(state, ready_, start.at());
}

StageStatistics Stage::statistics(Cycle cycles) const {
  assert(ready_ <= cycles);
  StageStatistics statistics = statistics_;
  statistics.idle += cycles - ready_;
  return statistics;
}

void Stage::run_in_lockstep(const sc_core::sc_time& period) {
  period_ = period;
  sc_core::sc_spawn([this] { lockstep(); }, (std::string(basename()) + "_process").c_str());
}

void Stage::lockstep() {
  Cycle now = 0;
  for (;;) {
    const Start start = next();
    if (start.at() == now) {
      fire(start);
      continue;
    }
    if (!start.known()) {
      sc_core::wait(woken_);
    } else if (chooses_by_arrival()) {
      sc_core::wait(static_cast<double>(start.at() - now) * period_, woken_);
    } else {
      sc_core::wait(static_cast<double>(start.at() - now) * period_);
    }
    now = sc_core::sc_time_stamp().value() / period_.value();
  }
}

}  // namespace pyrasim::hw
