// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <systemc>
#include <vector>

#include "hw_model/trace/event.h"
#include "hw_model/trace/event_lanes.h"
#include "hw_model/trace/subjects.h"

namespace pyrasim::hw {

/// Merges what stages and FIFOs report, each in ascending order of its own but run ahead of the others, into one stream
/// in the order of Event. It holds events back until a watermark has passed them, a date before which nothing can
/// happen any more. So both engines give the same stream, event by event, and no more is held than what stages are
/// ahead of each other, plus what comes between two watermarks.
class EventStream {
 public:
  void attach(EventSink& sink) { (sink.in_order() ? sinks_ : early_sinks_).push_back(&sink); }
  bool has_sinks_in_order() const { return !sinks_.empty(); }
  /// Who tells what events are about.
  void follow(Subjects subjects) { subjects_ = std::move(subjects); }

  /// An event of a stage or FIFO whose earlier ones have been put in.
  void put(const Event& event) {
    if (event.kind != Event::Kind::firing) {
      for (EventSink* sink : early_sinks_) sink->take(event);
    }
    if (sinks_.empty()) return;
    lanes_[static_cast<std::size_t>(event.kind)].put(event);
    if (++held_ == 1 && follows_kernel_) next_cycle();
  }
  /// Whether enough is held for a watermark to pay.
  bool due() const { return held_ >= due_at_; }
  /// Hands all events before `watermark` to the sinks.
  void release(Cycle watermark);
  /// For a machine whose dates are the kernel's: releases every cycle's events in the next one by itself. Before the
  /// simulation starts.
  void follow_kernel();

  /// The most events held at once.
  std::size_t peak() const { return std::max(peak_, held_); }

 private:
  static constexpr std::size_t least_due = 4096;  ///< so that what is left over each time matters little

  void next_cycle();

  std::vector<EventSink*> sinks_;        ///< that take events in order
  std::vector<EventSink*> early_sinks_;  ///< the others
  std::array<EventLanes, 3> lanes_;      ///< by Event::Kind
  std::vector<Event> same_date_;         ///< those being released
  std::size_t held_ = 0;                 ///< events
  std::size_t due_at_ = least_due;
  std::size_t peak_ = 0;
  Subjects subjects_;
  bool follows_kernel_ = false;
  sc_core::sc_event cycle_over_;
};

}  // namespace pyrasim::hw
