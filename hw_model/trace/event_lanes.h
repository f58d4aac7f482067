// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <vector>

#include "hw_model/trace/event.h"

namespace pyrasim::hw {

/// Events of one kind that wait to be taken by date. Those of a source ascend, so that nothing need be sorted.
class EventLanes {
 public:
  /// Later than all others of its source.
  void put(const Event& event) {
    if (event.source >= lanes_.size()) add(event.source);
    std::vector<Event>& events = lanes_[event.source].events;
    assert(events.empty() || events.back().at < event.at);
    if (events.empty()) {
      heads_[event.source] = event.at;
      Cycle& first = firsts_[event.source / block];
      first = std::min(first, event.at);
    }
    events.push_back(event);
  }

  /// Of the earliest; `never` where there is none.
  Cycle next_date() const {
    Cycle date = never;
    for (const Cycle first : firsts_) date = std::min(date, first);
    return date;
  }
  /// Appends those of next_date(), or of an earlier date none, in the order of their sources.
  void take(Cycle date, std::vector<Event>& events);
  /// Gives back the memory of those that have been taken.
  void tidy();

 private:
  static constexpr std::size_t block = 16;  ///< sources

  struct Lane {
    std::vector<Event> events;
    std::size_t taken = 0;  ///< of them, those that are over
  };

  void add(std::size_t source);

  std::vector<Lane> lanes_;    ///< by source
  std::vector<Cycle> heads_;   ///< dates of their next events; `never` where there is none
  std::vector<Cycle> firsts_;  ///< the earliest of each block of heads_, so that not all need be looked at each date
};

}  // namespace pyrasim::hw
