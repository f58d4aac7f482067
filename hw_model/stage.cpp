// SPDX-License-Identifier: Apache-2.0
#include "hw_model/stage.h"

namespace pyrasim::hw {

void Stage::woken() {
  if (work_ == nullptr) {
    woken_.notify(sc_core::SC_ZERO_TIME);
  } else if (!chooses_by_arrival()) {  // the engine asks the others when it is their turn
    work_->add(*this);
  }
}

void Stage::observe_wait(Cycle until, bool starved) {
  StageObserver::State state = StageObserver::State::idle;
  if (statistics_.firings > 0) state = starved ? StageObserver::State::starved : StageObserver::State::blocked;
  observer_->span(state, ready_, until);
}

StageStatistics Stage::statistics(Cycle cycles) const {
  assert(ready_ <= cycles);
  StageStatistics statistics = statistics_;
  statistics.idle += cycles - ready_;
  return statistics;
}

void Stage::run_in_lockstep(const sc_core::sc_time& period, const Cycle& last) {
  period_ = period;
  sc_core::sc_spawn([this, &last] { lockstep(last); }, (std::string(basename()) + "_process").c_str());
}

void Stage::lockstep(const Cycle& last) {
  Cycle now = 0;
  for (;;) {
    sleep();
    const Start start = next();
    if (start.known() && start.at() > last) return;
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
