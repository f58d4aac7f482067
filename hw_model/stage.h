// SPDX-License-Identifier: Apache-2.0
// What every box of the block diagram shares: local time, the rule of firing, and the account of its cycles.
#pragma once

#include <cassert>
#include <systemc>
#include <vector>

#include "hw_model/cycle.h"
#include "hw_model/fifo.h"

namespace pyrasim::hw {

/// When a stage can fire next, and what decides it: the latest of its own readiness, its tokens and its cells.
class Start {
 public:
  explicit Start(Cycle ready) : at_(ready) {}

  /// The firing reads a token of `fifo`.
  template <class Port>
  Start& needs_token(const Port& fifo) {
    return wait_until(fifo->token(), fifo.operator->(), true);
  }
  /// The firing writes into `fifo`.
  template <class Port>
  Start& needs_room(const Port& fifo) {
    return wait_until(fifo->room(), fifo.operator->(), false);
  }

  Cycle at() const { return at_; }
  bool known() const { return at_ != never; }
  /// The FIFO whose token or cell comes last; none where the stage's own readiness does.
  FifoBase* cause() const { return cause_; }
  bool starved() const { return starved_; }

 private:
  Start& wait_until(Cycle date, const FifoBase* fifo, bool starved) {
    if (date > at_) {
      at_ = date;
      cause_ = const_cast<FifoBase*>(fifo);
      starved_ = starved;
    }
    return *this;
  }

  Cycle at_;
  FifoBase* cause_ = nullptr;
  bool starved_ = false;
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
  virtual Start next() = 0;
  /// Fires at `now` = next().at().
  virtual void fire(Cycle now) = 0;
  /// Fires while the next firing is known; then sleeps.
  virtual void drain() = 0;
  /// Whether the stage chooses by what has arrived first; then an unseen token can change its next firing.
  virtual bool chooses_by_arrival() const { return false; }

  /// Accounts for the wait that ends with `start`, and fires.
  void fire(const Start& start) {
    account(start);
    fire(start.at());
  }

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
  /// Registers the process that runs this stage on the SystemC kernel, with no firing after `last`, which
  /// may change meanwhile and has to outlive the stage; before the simulation starts.
  void run_in_lockstep(const sc_core::sc_time& period, const Cycle& last);

  /// Books the cycles from the end of the last firing to `start`.
  void account(const Start& start) {
    assert(start.known() && start.at() >= ready_);
    const Cycle waited = start.at() - ready_;
    if (waited == 0) return;
    if (statistics_.firings == 0) {  // before the first firing the frame has not begun here
      statistics_.idle += waited;
    } else if (start.starved()) {
      statistics_.starved += waited;
      start.cause()->count_starved(waited);
    } else {
      statistics_.blocked += waited;
      start.cause()->count_blocked(waited);
    }
    if (observer_ != nullptr) observe_wait(start.at(), start.starved());
  }

 protected:
  explicit Stage(const sc_core::sc_module_name& name) : sc_module(name) {}
  /// The firing at `now` keeps the stage busy for `cycles` >= 1.
  void occupy(Cycle now, Cycle cycles) {
    ready_ = now + cycles;
    statistics_.busy += cycles;
    ++statistics_.firings;
    if (observer_ != nullptr) observer_->span(StageObserver::State::busy, now, ready_);
  }

 private:
  void woken() final;
  void observe_wait(Cycle until, bool starved);
  void lockstep(const Cycle& last);

  Cycle ready_ = 0;
  StageStatistics statistics_;
  StageObserver* observer_ = nullptr;
  WorkList* work_ = nullptr;
  sc_core::sc_event woken_;
  sc_core::sc_time period_;
};

class WorkList {
 public:
  void add(Stage& stage) { stages_.push_back(&stage); }
  /// Lets stages fire until none that is awake has a known next firing.
  void run() {
    for (std::size_t next = 0; next < stages_.size();) stages_[next++]->drain();  // more may come
    stages_.clear();
  }

 private:
  std::vector<Stage*> stages_;  ///< in the order in which they were woken
};

/// Gives a stage its drain(), with next() and fire() inlined: hence instantiated where these are defined, and there
/// only. A firing can wake the stage itself; so it sleeps first.
template <class Derived>
class StageOf : public Stage {
 public:
  [[gnu::flatten, gnu::noinline]] void drain() override {
    auto& self = static_cast<Derived&>(*this);
    sleep();
    for (Start start = self.Derived::next(); start.known(); start = self.Derived::next()) {
      account(start);
      self.Derived::fire(start.at());
    }
  }

 protected:
  using Stage::Stage;
};

}  // namespace pyrasim::hw
