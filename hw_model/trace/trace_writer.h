// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "hw_model/cycle.h"
#include "hw_model/report/critical_path.h"
#include "hw_model/stage/stage_state.h"
#include "hw_model/trace/event.h"

namespace pyrasim::hw {

/// By StageState.
inline constexpr std::array<std::string_view, 4> state_names{"idle", "busy", "starved", "blocked"};

/// A stretch of a unit's time, [begin, end) in cycles, in which it is in one state.
struct Span {
  std::size_t unit;  ///< in Processor::stages()
  StageState state;
  Cycle begin;
  Cycle end;
  Subject subject;  ///< that it works on
};

/// Writes what Timeline makes of a machine's events in one format. Of each unit spans ascend and do not overlap; of
/// each FIFO fills ascend; one with another they need not.
class TraceWriter {
 public:
  virtual ~TraceWriter() = default;
  virtual void span(const Span& span) = 0;
  /// The FIFO (in Processor::fifos()) holds so many tokens from the start of cycle `at` on.
  virtual void fill(std::size_t fifo, Cycle at, std::size_t tokens) = 0;
  /// Of the critical path, where the window asks for it; ascending.
  virtual void stretch(const PathStretch& stretch) = 0;
  /// The frame is over.
  virtual void finish(Cycle cycles) = 0;
};

}  // namespace pyrasim::hw
