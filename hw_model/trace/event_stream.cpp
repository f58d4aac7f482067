// SPDX-License-Identifier: Apache-2.0
#include "hw_model/trace/event_stream.h"

#include "hw_model/stage/kernel_time.h"

namespace pyrasim::hw {

void EventStream::release(Cycle watermark) {
  peak_ = peak();
  const auto next_date = [&] {
    return std::min({lanes_[0].next_date(), lanes_[1].next_date(), lanes_[2].next_date()});
  };
  for (Cycle date = next_date(); date < watermark; date = next_date()) {
    same_date_.clear();
    for (EventLanes& lanes : lanes_) lanes.take(date, same_date_);
    for (auto event = same_date_.begin(); event != same_date_.end(); ++event) {
      subjects_.tell(*event, {event + 1, same_date_.end()});
      for (EventSink* sink : sinks_) sink->take(*event);
    }
    held_ -= same_date_.size();
  }
  if (held_ > 0) {
    for (EventLanes& lanes : lanes_) lanes.tidy();
  }
  due_at_ = std::max(least_due, 2 * held_);
}

void EventStream::follow_kernel() {
  follows_kernel_ = true;
  sc_core::sc_spawn([this] {
    for (;;) {
      sc_core::wait(cycle_over_);
      release(sc_core::sc_time_stamp().value());
      if (held_ > 0) next_cycle();  // a stage came before this in the cycle
    }
  });
}

void EventStream::next_cycle() { cycle_over_.notify(kernel_time(1)); }

}  // namespace pyrasim::hw
