// SPDX-License-Identifier: Apache-2.0
#include "hw_model/trace/event_stream.h"

#include "hw_model/stage/kernel_time.h"

namespace pyrasim::hw {

void EventStream::Lanes::add(std::size_t source) {
  of.resize(source + 1);
  next.resize(source + 1, never);
  place.resize(source + 1);
}

void EventStream::Lanes::take(Cycle at, std::vector<Event>& events) {
  for (std::size_t source = 0; source < next.size(); ++source) {
    if (next[source] != at) continue;
    std::vector<Event>& lane = of[source];
    events.push_back(lane[place[source]++]);
    if (place[source] < lane.size()) {
      next[source] = lane[place[source]].at;
    } else {
      lane.clear();
      place[source] = 0;
      next[source] = never;
    }
  }
}

void EventStream::Lanes::tidy() {
  for (std::size_t source = 0; source < of.size(); ++source) {
    of[source].erase(of[source].begin(), of[source].begin() + static_cast<std::ptrdiff_t>(place[source]));
    place[source] = 0;
  }
}

Cycle EventStream::next_date() const {
  Cycle date = never;
  for (const Lanes& lanes : lanes_) {
    for (const Cycle next : lanes.next) date = std::min(date, next);
  }
  return date;
}

void EventStream::release(Cycle watermark) {
  peak_ = peak();
  for (Cycle date = next_date(); date < watermark; date = next_date()) {
    same_date_.clear();
    for (Lanes& lanes : lanes_) lanes.take(date, same_date_);
    for (auto event = same_date_.begin(); event != same_date_.end(); ++event) {
      subjects_.tell(*event, {event + 1, same_date_.end()});
      for (EventSink* sink : sinks_) sink->take(*event);
    }
    held_ -= same_date_.size();
  }
  if (held_ > 0) {
    for (Lanes& lanes : lanes_) lanes.tidy();
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
