// SPDX-License-Identifier: Apache-2.0
#include "hw_model/trace/event_lanes.h"

namespace pyrasim::hw {

void EventLanes::add(std::size_t source) {
  lanes_.resize(source + 1);
  heads_.resize(source + 1, never);
  firsts_.resize(source / block + 1, never);
}

void EventLanes::take(Cycle date, std::vector<Event>& events) {
  for (std::size_t k = 0; k < firsts_.size(); ++k) {
    if (firsts_[k] != date) continue;
    firsts_[k] = never;
    for (std::size_t source = k * block; source < std::min((k + 1) * block, heads_.size()); ++source) {
      Cycle& head = heads_[source];
      if (head == date) {
        Lane& lane = lanes_[source];
        events.push_back(lane.events[lane.taken++]);
        if (lane.taken < lane.events.size()) {
          head = lane.events[lane.taken].at;
        } else {
          lane.events.clear();
          lane.taken = 0;
          head = never;
        }
      }
      firsts_[k] = std::min(firsts_[k], head);
    }
  }
}

void EventLanes::tidy() {
  for (Lane& lane : lanes_) {
    lane.events.erase(lane.events.begin(), lane.events.begin() + static_cast<std::ptrdiff_t>(lane.taken));
    lane.taken = 0;
  }
}

}  // namespace pyrasim::hw
