// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <queue>
#include <string>
#include <string_view>
#include <vector>

#include "hw_model/processor.h"
#include "hw_model/trace/event.h"

namespace pyrasim::hw {

/// What a stretch of a frame's time is owed to.
enum class Owed : std::uint8_t {
  occupied,  ///< a unit that was still busy with its firing before
  service,   ///< a unit that worked on the token that is waited for
  latency,   ///< a unit that was free again, but whose token could not be read yet
  room,      ///< a FIFO that was full
};
inline constexpr std::array<std::string_view, 4> owed_names{"occupied", "service", "latency", "room"};

/// A stretch of the critical path, [begin, end) in cycles.
struct PathStretch {
  Owed owed;
  std::size_t place;  ///< in Processor::stages(); of `room` in Processor::fifos()
  Cycle begin;
  Cycle end;
  friend bool operator==(const PathStretch&, const PathStretch&) = default;
};

/// How many cycles of a frame are owed to what.
struct PathShare {
  Owed owed;
  std::size_t place;  ///< as in PathStretch
  Cycle cycles;
};

/// The chain of causes that took a frame its time: from the firing that ended last back to the first one, each firing
/// by what it waited for last: its own stage, a token, or room. Its stretches follow each other without gaps from cycle
/// 0 to the frame's end.
///
/// It is found while the frame runs, in memory that does not grow with it: a firing matters only for as long as another
/// one could still wait for it, and what the paths of all those have in common is settled.
class CriticalPath final : public EventSink {
 public:
  using Settled = std::function<void(const PathStretch& stretch)>;

  /// Of `processor`, whose simulation has not started, and whose events it has to be told. `settled`, if any, is told
  /// of every stretch, in order.
  explicit CriticalPath(const Processor& processor, Settled settled = {});

  void take(const Event& event) override;
  /// Settles the rest. The frame is over, or was broken off: then it is the path of what ended last so far.
  void finish();

  /// That are not 0, the largest first. Of what is settled; their sum is the frame's cycles in the end.
  std::vector<PathShare> shares() const;
  /// The most firings that were held at once.
  std::size_t peak() const { return firings_.size(); }

 private:
  using Number = std::uint32_t;
  static constexpr Number none = 0xFFFFFFFFU;

  /// A firing in the tree of what waited for what.
  struct Firing {
    Cycle at;
    Cycle until;  ///< the end of its busy time
    Cycle term;   ///< the last date at which another firing could be waiting for it
    std::uint32_t stage;
    std::uint32_t fifo;         ///< that it waited for; no_fifo: its stage's own readiness
    bool starved;               ///< of the FIFO: for a token
    bool waited_for = true;     ///< before its term
    Number cause;               ///< none: it is the first
    Number effects = 0;         ///< that have it as cause
    Number sum_of_effects = 0;  ///< of their numbers: of one, its number
  };
  /// Of a firing, or one that it had before its last token.
  struct Term {
    Cycle date;
    Number firing;
    friend bool operator>(const Term& a, const Term& b) { return a.date > b.date; }
  };
  struct Unit {
    Number last = none;
    std::vector<std::size_t> read;  ///< FIFOs, in the cycle of its next firing
  };
  struct Fifo {
    std::size_t writer;         ///< stage
    std::size_t reader;         ///< stage
    std::size_t unused;         ///< cells that were never written
    std::deque<Number> tokens;  ///< by whom they were written; none: they are preloaded
    std::deque<Number> cells;   ///< that are free again, by whom they were read
    Number newest = none;       ///< by whom the token was written that was read last
  };

  Number cause_of(const Event& firing) const;
  Number add(const Event& firing);
  void expire_before(Cycle date);
  void drop(Number firing);
  void settle_common();
  void settle(const Firing& cause, const Firing& effect);
  void settle(Owed owed, std::size_t place, Cycle begin, Cycle end);

  Settled settled_;
  std::array<std::vector<Cycle>, owed_names.size()> cycles_;  ///< [Owed][place]
  std::vector<Firing> firings_;
  std::vector<Number> unused_;  ///< of firings_
  std::vector<Unit> units_;
  std::vector<Fifo> fifos_;
  std::priority_queue<Term, std::vector<Term>, std::greater<>> terms_;
  Number root_ = none;  ///< all paths are the same up to it
};

/// "intersection_unit_3", or the name of the FIFO.
std::string place_name(const Processor& processor, Owed owed, std::size_t place);

/// "intersection_unit_3 occupied", "latency of intersection_unit_3".
std::string owed_text(std::string_view owed, std::string_view place);
std::string text_of(const Processor& processor, const PathStretch& stretch);

}  // namespace pyrasim::hw
