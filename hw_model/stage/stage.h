// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cassert>
#include <cstdint>
#include <string>
#include <systemc>
#include <utility>

#include "hw_model/cycle.h"
#include "hw_model/fifo/fifo_end.h"
#include "hw_model/run_control.h"
#include "hw_model/stage/stage_statistics.h"
#include "hw_model/stage/start.h"
#include "hw_model/trace/event_port.h"

namespace pyrasim::hw {

/// Stages that have work, in the decoupled engine.
class WorkList;

/// What every box of the block diagram shares: local time, the rule of firing, and the account of its cycles.
///
/// A stage fires at a date that Start works out from what the stage sees: it reads its tokens, writes its results, and
/// is busy for some cycles. Two engines drive the same definition: the decoupled one (DecoupledEngine) in whatever
/// order is fast, the lockstep one below with every advance of time as a real wait on the SystemC kernel.
class Stage : public sc_core::sc_module, public FifoEnd {
 public:
  /// The next firing, from what is known. Asking decides nothing.
  virtual Start next_start() const = 0;
  /// Fires at next_start(), which has to be known, and accounts for the wait that ends with it.
  virtual void fire_next() = 0;
  /// Fires while the next firing is known; then sleeps.
  virtual void drain() = 0;
  /// Whether the stage chooses by what has arrived first; then an unseen token can change its next firing.
  virtual bool chooses_by_arrival() const { return false; }

  /// The box of the block diagram that it is, or is one of: "pixel_scan", "intersection_units".
  const std::string& box() const { return box_; }
  void belongs_to(std::string box) { box_ = std::move(box); }

  /// Statistics of a frame of `cycles` cycles that is over.
  StageStatistics statistics(Cycle cycles) const;
  /// The end of the stage's last busy cycle.
  Cycle ready() const { return ready_; }

  /// The stage runs on the decoupled engine, which keeps `work`.
  void attach(WorkList& work);
  /// Every firing from now on is an event.
  void report_to(const EventPort& events) { events_ = events; }
  /// Registers the process that runs this stage on the SystemC kernel, whose time counts cycles; before the simulation
  /// starts. `control` has to outlive the stage.
  void run_in_lockstep(const RunControl& control);

 protected:
  explicit Stage(const sc_core::sc_module_name& name) : sc_module(name) {}

  /// Whether a firing has to be booked on its own: the first one, and all where somebody looks on.
  bool books_singly() const { return firings_ == 0 || events_; }
  /// Books the firing at `start` that keeps the stage busy for `cycles` >= 1.
  void book(const Start& start, Cycle cycles);
  /// Books `firings` further ones up to `ready`, whose waits have been booked.
  void book(std::uint64_t firings, Cycle ready) {
    firings_ += firings;
    ready_ = ready;
  }
  /// Books what a stage waits that is ready at `ready` and fires at `start`; not for its first firing.
  void book_wait(Cycle ready, const Start& start) {
    assert(start.known() && start.at() >= ready);
    if (start.at() == ready) return;
    start.cause()->cycles += start.at() - ready;
    (start.cause()->starved ? starved_ : blocked_) += start.at() - ready;
  }

 private:
  void woken() final;
  void lockstep(const RunControl& control);

  std::string box_;
  Cycle ready_ = 0;
  std::uint64_t firings_ = 0;
  Cycle idle_ = 0;  ///< before the first firing
  Cycle starved_ = 0;
  Cycle blocked_ = 0;
  EventPort events_;
  bool decoupled_ = false;
  sc_core::sc_event woken_;
};

}  // namespace pyrasim::hw
