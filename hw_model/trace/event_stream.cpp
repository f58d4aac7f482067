// SPDX-License-Identifier: Apache-2.0
#include "hw_model/trace/event_stream.h"

#include "hw_model/stage/kernel_time.h"

namespace pyrasim::hw {

void EventStream::release(Cycle watermark) {
  peak_ = peak();
  const auto early =
      std::partition(held_.begin(), held_.end(), [&](const Event& event) { return event.at < watermark; });
  std::sort(held_.begin(), early);
  for (auto event = held_.begin(); event != early; ++event) {
    subjects_.tell(*event, {event + 1, early});
    for (EventSink* sink : sinks_) sink->take(*event);
  }
  held_.erase(held_.begin(), early);
  due_at_ = std::max(least_due, 2 * held_.size());
}

void EventStream::follow_kernel() {
  follows_kernel_ = true;
  sc_core::sc_spawn([this] {
    for (;;) {
      sc_core::wait(cycle_over_);
      release(sc_core::sc_time_stamp().value());
      if (!held_.empty()) next_cycle();  // a stage came before this in the cycle
    }
  });
}

void EventStream::next_cycle() { cycle_over_.notify(kernel_time(1)); }

}  // namespace pyrasim::hw
