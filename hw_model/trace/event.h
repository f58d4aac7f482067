// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <tuple>

#include "hw_model/cycle.h"
#include "hw_model/stage/stage_state.h"
#include "hw_model/trace/subject.h"

namespace pyrasim::hw {

inline constexpr std::uint32_t no_fifo = 0xFFFFFFFFU;

/// Something that happened in a machine. A firing is one event, with the wait that it ended: only then is it known what
/// the stage waited for.
struct Event {
  /// In the order of the stream at equal dates: what a firing takes comes before it, what it gives after.
  enum class Kind : std::uint8_t { read, firing, write };

  Kind kind{};
  StageState waited{};       ///< of a firing: what the stage was from `since` on; idle: it is its first
  std::uint32_t source = 0;  ///< of a firing: its place in Processor::stages(); else the FIFO's in Processor::fifos()
  std::uint32_t cause = no_fifo;  ///< of a firing: the FIFO, in Processor::fifos(), whose token or room came last;
                                  ///< none: the stage's own readiness did
  Cycle at = 0;                   ///< cycle of the read, of the firing's start, of the write
  Cycle since = 0;    ///< of a firing: the end of the busy time before it; equal to `at` where it did not wait
  Cycle until = 0;    ///< of a firing: the end of its own busy time; of a write: when the token can be read
  Subject subject{};  ///< see Subjects; in the end, of all that is about one

  /// Strict for the events of a machine: no stage fires twice in a cycle, and no FIFO is written or read twice.
  friend bool operator<(const Event& a, const Event& b) {
    return std::tie(a.at, a.kind, a.source) < std::tie(b.at, b.kind, b.source);
  }
  friend bool operator==(const Event&, const Event&) = default;
};

/// Takes a machine's events. To be attached before the simulation starts, and to outlive it.
class EventSink {
 public:
  virtual ~EventSink() = default;
  /// Whether it takes everything in the order of Event. If not, it takes reads and writes alone, without their rays, as
  /// soon as they are known: each FIFO's reads ascend and so do its writes, but nothing is held or sorted for it.
  virtual bool in_order() const { return true; }
  virtual void take(const Event& event) = 0;
};

}  // namespace pyrasim::hw
