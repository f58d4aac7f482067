// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "files/output_file.h"
#include "hw_model/processor.h"
#include "hw_model/report/critical_path.h"
#include "hw_model/trace/trace_window.h"
#include "hw_model/trace/trace_writer.h"
#include "hw_model/trace/windowed_sink.h"

namespace pyrasim::hw {

/// Makes spans of units and fills of FIFOs of a machine's events, and hands to a writer what its window shows: a span
/// that reaches beyond it is cut.
///
/// A token counts from the cycle of its write to that of its read, both included.
class Timeline final : public WindowedSink {
 public:
  /// Of `processor`, whose simulation has not started; all outlive it.
  /// `output`: what the writer fills.
  Timeline(Processor& processor, const TraceWindow& window, TraceWriter& writer, const OutputFile& output);
  Timeline(const Timeline&) = delete;
  Timeline& operator=(const Timeline&) = delete;

  /// Of a frame of `cycles` that is over, or was broken off there.
  void finish(Cycle cycles);
  std::optional<Cycle> full() const { return window_.full; }

 private:
  void take_shown(const Event& event) override;

  struct Unit {
    bool shown = false;
    Cycle until = 0;  ///< the end of its last span
  };
  struct Fill {
    bool shown = false;
    std::size_t tokens = 0;
    bool written = false;
    std::array<Cycle, 2> losses{never,
                                never};  ///< dates, the earlier one first: at most one of a cycle and of the next
  };

  void show(Span span);
  void show(const PathStretch& stretch);
  void change(std::size_t fifo, Cycle at, std::size_t tokens);
  /// Takes the losses before `date` into account.
  void lose_before(std::size_t fifo, Cycle date);

  TraceWindow window_;
  TraceWriter& writer_;
  const OutputFile& output_;
  std::vector<Unit> units_;
  std::vector<Fill> fifos_;
  std::optional<CriticalPath> critical_path_;
  std::optional<PathStretch> stretch_;  ///< the newest one, with those before it that are owed to the same
};

}  // namespace pyrasim::hw
