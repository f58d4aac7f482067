// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "hw_model/stage/stage.h"

namespace pyrasim::hw {

/// A stage's behaviour, which `Derived` defines by a type and three functions:
/// - `Plan`: what a firing does; `Start start` in it says when;
/// - `Ends ends() const`: its readers and writers, for as long as it fires;
/// - `Plan next(const Ends&, Cycle ready) const`: the next firing of the stage that is ready at `ready`, of which
///   nothing but `start` counts where that is not known;
/// - `Cycle fire(Ends&, const Plan&)`: fires as planned; returns for how many cycles that keeps the stage busy.
/// They are inlined here; hence instantiated where they are defined, and there only.
template <class Derived>
class StageOf : public Stage {
 public:
  /// The next firing, from what is known. It holds until the stage fires, or is told of something new.
  auto plan() const {
    const auto ends = derived().ends();
    return derived().next(ends, ready());
  }
  /// Fires as planned.
  void fire_planned(const auto& plan) {
    auto ends = derived().ends();
    book(plan.start, derived().fire(ends, plan));
  }

  Start next_start() const final { return plan().start; }
  void fire_next() final { fire_planned(plan()); }
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
    const auto next = plan();
    if (next.start.at() >= horizon) return false;
    fire_planned(next);
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
      const auto next = derived().next(ends, ready);
      if (next.start.at() >= horizon) break;
      book_wait(ready, next.start);
      ready = next.start.at() + derived().fire(ends, next);
      ++firings;
    } while (goes_on(ends));
    book(firings, ready);
    return firings > 0;
  }

 private:
  const Derived& derived() const { return static_cast<const Derived&>(*this); }
  Derived& derived() { return static_cast<Derived&>(*this); }
};

}  // namespace pyrasim::hw
