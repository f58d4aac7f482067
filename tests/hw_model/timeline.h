// SPDX-License-Identifier: Apache-2.0
// The Processor's Timeline, and where two of them part.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "cycle_loop.h"
#include "hw_model/processor.h"

namespace pyrasim::hw {

/// Notes the dates of every FIFO of one machine. To be made before the simulation runs, and to outlive it.
class TimelineRecorder final : public EventSink {
 public:
  explicit TimelineRecorder(Processor& machine) : machine_(machine), fifos_(machine.fifos().size()) {
    machine.attach(*this);
  }
  TimelineRecorder(const TimelineRecorder&) = delete;
  TimelineRecorder& operator=(const TimelineRecorder&) = delete;

  void take(const Event& event) override {
    if (event.kind == Event::Kind::write) fifos_[event.source].writes.push_back(event.at);
    if (event.kind == Event::Kind::read) fifos_[event.source].reads.push_back(event.at);
  }

  Timeline timeline() const {
    Timeline result{machine_.cycles(), {}};
    for (std::size_t k = 0; k < fifos_.size(); ++k) result.fifos[machine_.fifos()[k]->basename()] = fifos_[k];
    return result;
  }

 private:
  const Processor& machine_;
  std::vector<FifoDates> fifos_;
};

/// Finds the first date, in time, that differs between two timelines: what comes before it is the same, so it is the
/// one that tells what went wrong.
class FirstDifference {
 public:
  FirstDifference(const Timeline& a, const Timeline& b) {
    for (const auto& [name, dates] : a.fifos) {
      if (!b.fifos.contains(name)) note(0, name + " is only in the first");
    }
    for (const auto& [name, dates] : b.fifos) {
      const auto its_a = a.fifos.find(name);
      if (its_a == a.fifos.end()) {
        note(0, name + " is only in the second");
      } else {
        compare(name + " write", its_a->second.writes, dates.writes);
        compare(name + " read", its_a->second.reads, dates.reads);
      }
    }
    compare("the frame's cycles", {a.cycles}, {b.cycles});
  }

  /// Empty where the two are the same.
  const std::string& text() const { return text_; }

 private:
  void compare(const std::string& what, const std::vector<Cycle>& a, const std::vector<Cycle>& b) {
    const auto date = [](const std::vector<Cycle>& dates, std::size_t k) {
      return k < dates.size() ? dates[k] : never;
    };
    const auto shown = [](Cycle at) { return at == never ? "never" : std::to_string(at); };
    for (std::size_t k = 0; k < std::max(a.size(), b.size()); ++k) {
      const Cycle at_a = date(a, k);
      const Cycle at_b = date(b, k);
      if (at_a == at_b) continue;
      note(std::min(at_a, at_b), what + " " + std::to_string(k) + ": " + shown(at_a) + " against " + shown(at_b));
      return;
    }
  }

  void note(Cycle at, const std::string& text) {
    if (!text_.empty() && at >= at_) return;
    at_ = at;
    text_ = text;
  }

  Cycle at_ = never;
  std::string text_;
};

}  // namespace pyrasim::hw
