// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <set>

#include "hw_model/processor.h"
#include "hw_model/trace/event.h"
#include "hw_model/trace/trace_window.h"

namespace pyrasim::hw {

/// A sink of those of a machine's events that are about a window's pixels; where it names none, of all. Units do not
/// wait for pixels, so that of waits nothing is left.
class WindowedSink : public EventSink {
 public:
  void take(const Event& event) final {
    if (pixels_.empty()) {
      take_shown(event);
    } else if (pixels_.contains(event.subject.pixel)) {
      Event without_wait = event;
      without_wait.waited = StageState::idle;
      if (event.kind == Event::Kind::firing) without_wait.since = event.at;
      take_shown(without_wait);
    }
  }

 protected:
  /// Of `processor`, whose pixels the window's are.
  WindowedSink(const Processor& processor, const TraceWindow& window) {
    for (const auto& [row, column] : window.pixels) pixels_.insert(processor.pixel_at(row, column).value());
  }
  virtual void take_shown(const Event& event) = 0;
  /// That are shown of `fifo` when the frame begins.
  std::size_t tokens_before(const FifoBase& fifo) const { return pixels_.empty() ? fifo.size() : 0; }

 private:
  std::set<std::uint32_t> pixels_;
};

}  // namespace pyrasim::hw
