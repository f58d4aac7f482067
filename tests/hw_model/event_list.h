// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "hw_model/processor.h"

namespace pyrasim::hw {

/// Keeps all events of one machine. To be made before the simulation runs, and to outlive it.
class EventList final : public EventSink {
 public:
  explicit EventList(Processor& machine) : machine_(machine) { machine.attach(*this); }
  EventList(const EventList&) = delete;
  EventList& operator=(const EventList&) = delete;

  void take(const Event& event) override { all_.push_back(event); }

  const Processor& machine() const { return machine_; }
  const std::vector<Event>& all() const { return all_; }
  /// Of one kind and source, in order. `name`: of the stage or FIFO.
  std::vector<Event> of(Event::Kind kind, const std::string& name) const {
    std::vector<Event> result;
    for (const Event& event : all_) {
      if (event.kind == kind && name_of(event) == name) result.push_back(event);
    }
    return result;
  }
  std::string name_of(const Event& event) const {
    if (event.kind == Event::Kind::firing) return machine_.stages()[event.source]->basename();
    return machine_.fifos()[event.source]->basename();
  }

 private:
  const Processor& machine_;
  std::vector<Event> all_;
};

}  // namespace pyrasim::hw
