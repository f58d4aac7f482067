// SPDX-License-Identifier: Apache-2.0
// What every box of the block diagram shares: local time, the rule of firing, and the account of its cycles.
#pragma once

#include <cassert>
#include <systemc>
#include <vector>

#include "hw_model/cycle.h"
#include "hw_model/fifo.h"
#include "hw_model/run_control.h"

namespace pyrasim::hw {

/// `cycles` as the SystemC kernel counts time: one unit of its resolution each, whatever the clock, which only turns
/// cycles into seconds. In picoseconds, a frame at 1 kHz would pass the kernel's 64 bits after 1.8e10 cycles.
inline sc_core::sc_time kernel_time(Cycle cycles) { return sc_core::sc_time::from_value(cycles); }

/// When a stage can fire next, and what decides it: the latest of its own readiness, its tokens and its cells.
class Start {
 public:
  explicit Start(Cycle ready) : at_(ready) {}

  /// The firing reads a token of `fifo`: of the FIFO, or its FifoReader.
  template <class Fifo>
  Start& needs_token(Fifo& fifo) {
    return wait_until(fifo.token(), fifo.starved());
  }
  /// The firing writes into `fifo`: the FIFO, or its FifoWriter.
  template <class Fifo>
  Start& needs_room(Fifo& fifo) {
    return wait_until(fifo.room(), fifo.blocked());
  }

  Cycle at() const { return at_; }
  bool known() const { return at_ != never; }
  /// For the token or cell that comes last; none where the stage's own readiness does.
  WaitCounter* cause() const { return cause_; }

 private:
  Start& wait_until(Cycle date, WaitCounter& wait) {
    if (date > at_) {
      at_ = date;
      cause_ = &wait;
    }
    return *this;
  }

  Cycle at_;
  WaitCounter* cause_ = nullptr;
};

/// Where a stage's cycles went. The four add up to the frame's cycles.
struct StageStatistics {
  Cycle busy = 0;
  Cycle starved = 0;  ///< no input
  Cycle blocked = 0;  ///< no room for the output
  Cycle idle = 0;     ///< frame not begun, or over
  std::uint64_t firings = 0;
};

/// Told how a stage spends its time; spans ascend and do not overlap.
class StageObserver {
 public:
  enum class State : std::uint8_t { idle, busy, starved, blocked };
  virtual ~StageObserver() = default;
  virtual void span(State state, Cycle from, Cycle to) = 0;
};

/// Stages that have work, in the decoupled engine.
class WorkList;

/// A stage fires at a date that Start works out from what the stage sees: it reads its tokens, writes its results, and
/// is busy for some cycles. Two engines drive the same definition: the decoupled one (DecoupledEngine) in whatever
/// order is fast, the lockstep one below with every advance of time as a real wait on the SystemC kernel.
class Stage : public sc_core::sc_module, public FifoEnd {
 public:
  /// The next firing, from what is known.
  virtual Start next_start() = 0;
  /// Fires at `start` = next_start(), and accounts for the wait that ends with it.
  virtual void fire_at(const Start& start) = 0;
  /// Fires while the next firing is known; then sleeps.
  virtual void drain() = 0;
  /// Whether the stage chooses by what has arrived first; then an unseen token can change its next firing.
  virtual bool chooses_by_arrival() const { return false; }

  /// Statistics of a frame of `cycles` cycles that is over.
  StageStatistics statistics(Cycle cycles) const;
  /// The end of the stage's last busy cycle.
  Cycle ready() const { return ready_; }

  /// The stage runs on the decoupled engine, which keeps `work`.
  void attach(WorkList& work) {
    work_ = &work;
    sleep();  // it may have been told of preloaded tokens
  }
  void observe(StageObserver* observer) { observer_ = observer; }
  /// Registers the process that runs this stage on the SystemC kernel, whose time counts cycles; before the simulation
  /// starts. `control` has to outlive the stage.
  void run_in_lockstep(const RunControl& control);

 protected:
  explicit Stage(const sc_core::sc_module_name& name) : sc_module(name) {}

  /// Whether a firing has to be booked on its own: the first one, and all where somebody looks on.
  bool books_singly() const { return firings_ == 0 || observer_ != nullptr; }
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

  Cycle ready_ = 0;
  std::uint64_t firings_ = 0;
  Cycle idle_ = 0;  ///< before the first firing
  Cycle starved_ = 0;
  Cycle blocked_ = 0;
  StageObserver* observer_ = nullptr;
  WorkList* work_ = nullptr;
  sc_core::sc_event woken_;
};

class WorkList {
 public:
  void add(Stage& stage) { stages_.push_back(&stage); }
  /// Lets stages fire until none that is awake has a known next firing.
  void run() {
    for (std::size_t next = 0; next < stages_.size();) {  // more may come
      Stage& stage = *stages_[next++];
      if (stage.awake()) stage.drain();
    }
    stages_.clear();
  }

 private:
  std::vector<Stage*> stages_;  ///< in the order in which they were woken
};

/// A stage's behaviour, which `Derived` defines by three functions:
/// - `Ends ends()`: its readers and writers, for as long as it fires;
/// - `Start next(Ends&, Cycle ready)`: the next firing of the stage that is ready at `ready`;
/// - `Cycle fire(Ends&, Cycle now)`: fires at `now`; returns for how many cycles that keeps the stage busy.
/// They are inlined here; hence instantiated where they are defined, and there only.
template <class Derived>
class StageOf : public Stage {
 public:
  Start next_start() final {
    auto ends = derived().ends();
    return derived().next(ends, ready());
  }
  void fire_at(const Start& start) final {
    auto ends = derived().ends();
    book(start, derived().fire(ends, start.at()));
  }
  [[gnu::flatten, gnu::noinline]] void drain() final {
    sleep();  // a firing can wake the stage itself
    while (books_singly()) {
      if (!fire_one(never)) return;
    }
    fire_in_a_row(never, [](const auto&) { return true; });
  }

 protected:
  using Stage::Stage;

  /// Fires, if that is before `horizon`. Returns whether it did.
  [[gnu::noinline]] bool fire_one(Cycle horizon) {
    const Start start = next_start();
    if (start.at() >= horizon) return false;
    fire_at(start);
    return true;
  }
  /// Fires before `horizon`, and again for as long as `goes_on(ends)`. Returns whether it fired at all. Not where
  /// firings are booked singly.
  template <class Condition>
  bool fire_in_a_row(Cycle horizon, const Condition& goes_on) {
    auto ends = derived().ends();
    Cycle ready = this->ready();
    std::uint64_t firings = 0;
    do {
      const Start start = derived().next(ends, ready);
      if (start.at() >= horizon) break;
      book_wait(ready, start);
      ready = start.at() + derived().fire(ends, start.at());
      ++firings;
    } while (goes_on(ends));
    book(firings, ready);
    return firings > 0;
  }

 private:
  Derived& derived() { return static_cast<Derived&>(*this); }
};

}  // namespace pyrasim::hw
