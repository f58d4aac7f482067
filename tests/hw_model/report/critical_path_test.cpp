// SPDX-License-Identifier: Apache-2.0
#include "hw_model/report/critical_path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <map>
#include <numeric>
#include <random>

#include "../../test_scenes.h"
#include "../event_list.h"
#include "../random_machine.h"
#include "../simulation.h"

namespace pyrasim::hw {
namespace {

/// A critical path with its stretches, in order.
struct Watched {
  explicit Watched(Processor& machine)
      : path(machine, [this](const PathStretch& stretch) { stretches.push_back(stretch); }) {
    machine.attach(path);
  }
  std::vector<PathStretch> stretches;
  CriticalPath path;
};

Cycle cycles_of(const std::vector<PathShare>& shares) {
  return std::accumulate(shares.begin(), shares.end(), Cycle{0},
                         [](Cycle sum, const PathShare& share) { return sum + share.cycles; });
}

/// The path looked up backwards in the list of everything that happened.
class LookedUp {
 public:
  explicit LookedUp(const EventList& list) : machine_(list.machine()) {
    for (const FifoBase* fifo : machine_.fifos()) preloaded_.push_back(fifo->size());
    reads_.resize(preloaded_.size());
    writes_.resize(preloaded_.size());
  }
  /// What happened since.
  std::vector<PathStretch> path(const EventList& list) {
    Event last;
    for (const Event& event : list.all()) {
      if (event.kind == Event::Kind::read) reads_[event.source].push_back(event.at);
      if (event.kind == Event::Kind::write) writes_[event.source].push_back(event.at);
      if (event.kind != Event::Kind::firing) continue;
      firings_[event.source][event.at] = event;
      if (event.until >= last.until) last = event;
    }
    add(Owed::service, last.source, last.at, last.until);
    for (Event firing = last; firing.at > 0;) firing = before(firing);
    std::reverse(stretches_.begin(), stretches_.end());
    return stretches_;
  }

 private:
  Event before(const Event& firing) {
    if (firing.cause == no_fifo) {
      const Event cause = std::prev(firings_[firing.source].find(firing.at))->second;
      add(Owed::occupied, firing.source, cause.at, firing.at);
      return cause;
    }
    const Wire& wire = machine_.wires()[firing.cause];
    const auto index = [&](const std::vector<Cycle>& dates) {
      return static_cast<std::size_t>(std::lower_bound(dates.begin(), dates.end(), firing.at) - dates.begin());
    };
    const std::size_t preloaded = preloaded_[firing.cause];
    if (wire.reader == machine_.stages()[firing.source]) {
      const Cycle written = writes_[firing.cause].at(index(reads_[firing.cause]) - preloaded);
      const Event cause = firings_.at(machine_.number_of(*wire.writer)).at(written);
      add(Owed::latency, cause.source, std::min(cause.until, firing.at), firing.at);
      add(Owed::service, cause.source, cause.at, std::min(cause.until, firing.at));
      return cause;
    }
    const std::size_t cells = wire.fifo->depth() - preloaded;
    const Cycle read = reads_[firing.cause].at(index(writes_[firing.cause]) - cells);
    add(Owed::room, firing.cause, read, firing.at);
    return firings_.at(machine_.number_of(*wire.reader)).at(read);
  }
  void add(Owed owed, std::size_t place, Cycle begin, Cycle end) {
    if (begin < end) stretches_.push_back({owed, place, begin, end});
  }

  const Processor& machine_;
  std::vector<std::size_t> preloaded_;
  std::vector<std::vector<Cycle>> reads_, writes_;
  std::map<std::size_t, std::map<Cycle, Event>> firings_;
  std::vector<PathStretch> stretches_;
};

/// Which of two firings that end together comes last is free: then their busy cycles alone may differ.
TEST(CriticalPath, IsTheChainOfCausesBackFromTheEnd) {
  std::mt19937_64 random(67);
  Simulation simulation;
  std::deque<Watched> watched;
  std::deque<EventList> lists;
  std::deque<LookedUp> looked_up;
  for (int k = 0; k < 24; ++k) {
    SimulationOptions options;
    options.max_level = static_cast<int>(random() % 4);
    options.engine = k % 2 == 0 ? Engine::decoupled : Engine::lockstep;
    Scene scene = random_scene(random(), {12, 12, 0}, 12, 10);
    if (k % 3 == 0) scene = under_lights(std::move(scene), random);
    Processor& machine = simulation.add(scene, random_machine(random, options.max_level), options);
    watched.emplace_back(machine);
    lists.emplace_back(machine);
    looked_up.emplace_back(lists.back());
  }
  simulation.run();
  std::array<std::size_t, owed_names.size()> kinds{};
  for (std::size_t k = 0; k < lists.size(); ++k) {
    const Processor& machine = lists[k].machine();
    watched[k].path.finish();
    Cycle end = 0;
    for (const PathStretch& stretch : watched[k].stretches) {
      EXPECT_EQ(stretch.begin, end);
      EXPECT_LT(stretch.begin, stretch.end);
      end = stretch.end;
      ++kinds[static_cast<std::size_t>(stretch.owed)];
    }
    EXPECT_EQ(end, machine.cycles());
    EXPECT_EQ(cycles_of(watched[k].path.shares()), machine.cycles());
    EXPECT_TRUE(watched[k].stretches == looked_up[k].path(lists[k])) << "machine " << k;
  }
  for (const std::size_t of_kind : kinds) EXPECT_GT(of_kind, 0U);
}

/// What lies behind is settled: a longer frame needs no more memory.
TEST(CriticalPath, HoldsNoMoreForALongerFrame) {
  Simulation simulation;
  std::deque<Watched> watched;
  for (const int rows : {12, 96}) {
    watched.emplace_back(simulation.add(random_scene(5, {12, rows, 0}, 12, 10), {}, {}));
  }
  simulation.run();
  EXPECT_LT(watched[1].path.peak(), 2 * watched[0].path.peak());
}

/// Where one unit alone does the work of 40 cycles a ray, the frame is owed to it.
TEST(CriticalPath, OfASlowUnitIsItsWork) {
  MachineSpec spec;
  spec.intersection_units = 1;
  spec.intersection_cost.ray = 40;
  Simulation simulation;
  Processor& machine = simulation.add(random_scene(5, {16, 16, 0}, 12, 10), spec, {});
  Watched watched(machine);
  simulation.run();
  watched.path.finish();
  const std::vector<PathShare> shares = watched.path.shares();
  EXPECT_EQ(shares.front().owed, Owed::occupied);
  EXPECT_EQ(place_name(machine, shares.front().owed, shares.front().place), "intersection_unit_0");
  EXPECT_GT(shares.front().cycles, machine.cycles() * 9 / 10);
}

}  // namespace
}  // namespace pyrasim::hw
