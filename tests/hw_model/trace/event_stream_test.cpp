// SPDX-License-Identifier: Apache-2.0
#include "hw_model/trace/event_stream.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <deque>
#include <map>
#include <random>
#include <utility>

#include "../../test_scenes.h"
#include "../event_list.h"
#include "../random_machine.h"
#include "../simulation.h"
#include "hw_model/trace/event_port.h"

namespace pyrasim::hw {
namespace {

/// Where two streams part; empty where they are the same.
std::string first_difference(const EventList& a, const EventList& b) {
  const auto shown = [](const EventList& list, std::size_t k) {
    if (k >= list.all().size()) return std::string("nothing");
    const Event& event = list.all()[k];
    return list.name_of(event) + " kind " + std::to_string(static_cast<int>(event.kind)) + " at " +
           std::to_string(event.at) + " ray " + std::to_string(event.subject.ray);
  };
  const auto [in_a, in_b] = std::mismatch(a.all().begin(), a.all().end(), b.all().begin(), b.all().end());
  if (in_a == a.all().end() && in_b == b.all().end()) return "";
  const auto k = static_cast<std::size_t>(in_a - a.all().begin());
  return "event " + std::to_string(k) + ": " + shown(a, k) + " against " + shown(b, k);
}

/// Each later than the one before it by the order of Event: so no watermark came too early.
void expect_ordered(const EventList& list) {
  const auto& all = list.all();
  for (std::size_t k = 1; k < all.size(); ++k) ASSERT_LT(all[k - 1], all[k]) << "event " << k;
}

/// Firings and the waits between them are the stages' statistics; writes and reads are the FIFOs'.
void expect_all_there(const EventList& list) {
  const Processor& machine = list.machine();
  for (const Stage* stage : machine.stages()) {
    const StageStatistics statistics = stage->statistics(machine.cycles());
    std::array<Cycle, 4> cycles{};
    Cycle end = 0;
    const std::vector<Event> firings = list.of(Event::Kind::firing, stage->basename());
    for (const Event& firing : firings) {
      EXPECT_EQ(firing.since, end);
      if (firing.waited != StageState::idle) {
        const Wire& wire = machine.wires()[firing.cause];
        EXPECT_EQ(firing.waited == StageState::starved ? wire.reader : wire.writer, stage);
      } else {
        EXPECT_TRUE(firing.cause == no_fifo || &firing == &firings.front());
      }
      EXPECT_LT(firing.at, firing.until);
      cycles[static_cast<std::size_t>(firing.waited)] += firing.at - firing.since;
      cycles[static_cast<std::size_t>(StageState::busy)] += firing.until - firing.at;
      end = firing.until;
    }
    cycles[static_cast<std::size_t>(StageState::idle)] += machine.cycles() - end;
    EXPECT_EQ(firings.size(), statistics.firings) << stage->name();
    EXPECT_EQ(cycles, (std::array{statistics.idle, statistics.busy, statistics.starved, statistics.blocked}))
        << stage->name();
  }
  for (const FifoBase* fifo : machine.fifos()) {
    EXPECT_EQ(list.of(Event::Kind::read, fifo->basename()).size(), fifo->statistics().tokens) << fifo->name();
  }
}

TEST(EventStream, IsTheSameOnBothEngines) {
  std::mt19937_64 random(41);
  Simulation simulation;
  std::deque<EventList> decoupled;
  std::deque<EventList> lockstep;
  for (int k = 0; k < 60; ++k) {
    SimulationOptions options;
    options.max_level = static_cast<int>(random() % 6);
    Scene scene = random_scene(random(), {12, 12, k % 4 == 0 ? 1 : 0}, static_cast<int>(1 + random() % 16),
                               static_cast<int>(1 + random() % 16));
    if (k % 3 == 0) scene = under_lights(std::move(scene), random);
    const MachineSpec spec = random_machine(random, options.max_level);
    decoupled.emplace_back(simulation.add(scene, spec, options));
    options.engine = Engine::lockstep;
    lockstep.emplace_back(simulation.add(scene, spec, options));
  }
  simulation.run();
  std::size_t merged_in_parts = 0;
  for (std::size_t k = 0; k < decoupled.size(); ++k) {
    SCOPED_TRACE("machine " + std::to_string(k));
    expect_ordered(decoupled[k]);
    expect_ordered(lockstep[k]);
    expect_all_there(decoupled[k]);
    EXPECT_EQ(first_difference(decoupled[k], lockstep[k]), "");
    if (decoupled[k].machine().events().peak() < decoupled[k].all().size()) ++merged_in_parts;
  }
  EXPECT_GT(merged_in_parts, 20U);
}

/// Edges from top to bottom, whatever the number of rows.
Scene with_edges_everywhere(int rows) {
  Scene scene = random_scene(3, {30, 30, 0}, 16, rows);
  scene.camera.screen.dy = 1.2 / rows;
  return scene;
}

/// Edges at the top alone: the controller waits from there to the end.
Scene with_edges_at_the_top(int rows) {
  Scene scene = empty_scene(16, rows, 1.0 / 16);
  scene.objects = {object(Sphere{{10, 10 * (rows / 2 - 8) / 16.0, 0}, 1})};
  return scene;
}

/// As many events are held for a frame ten times as high.
TEST(EventStream, HoldsNoMoreForALongerFrame) {
  Simulation simulation;
  std::deque<EventList> lists;
  MachineSpec deep = with_all_fifos({}, 100);
  deep.pixels_in_flight = 100;
  MachineSpec choosing;
  choosing.dispatch = Dispatch::first_free;
  for (const auto& scene : {with_edges_everywhere, with_edges_at_the_top}) {
    for (const MachineSpec& spec : {MachineSpec{}, deep, choosing}) {
      for (const int rows : {120, 1200}) lists.emplace_back(simulation.add(scene(rows), spec, {}));
    }
  }
  simulation.run();
  for (std::size_t k = 0; k < lists.size(); k += 2) {
    SCOPED_TRACE(k);
    const std::size_t low = lists[k].machine().events().peak();
    const std::size_t high = lists[k + 1].machine().events().peak();
    EXPECT_GT(lists[k + 1].all().size(), 4 * lists[k].all().size());
    EXPECT_LE(high, low * 5 / 4) << "of " << lists[k + 1].all().size();
  }
}

/// Is told of a date, and notes how late.
class Lateness final : public EventSink {
 public:
  explicit Lateness(Processor& machine) { machine.attach(*this); }
  void take(const Event& event) override {
    const Cycle late = sc_core::sc_time_stamp().value() - event.at;
    least_ = std::min(least_, late);
    most_ = std::max(most_, late);
  }
  Cycle least() const { return least_; }
  Cycle most() const { return most_; }

 private:
  Cycle least_ = never;
  Cycle most_ = 0;
};

/// So that what a module beside the machine gets from a sink, with a cycle's latency, is there in time.
TEST(EventStream, OfALockstepMachineComesInTheNextCycle) {
  SimulationOptions options;
  options.engine = Engine::lockstep;
  Simulation simulation;
  Processor& machine = simulation.add(random_scene(3, {30, 30, 0}, 16, 40), {}, options);
  Lateness lateness(machine);
  simulation.run();
  EXPECT_EQ(lateness.least(), 1U);
  EXPECT_EQ(lateness.most(), 1U);
  EXPECT_LT(machine.events().peak(), 2 * (machine.stages().size() + 2 * machine.fifos().size()));
}

/// A run that ends before its frame has told all that happened in it.
TEST(EventStream, EndsWithTheRun) {
  std::deque<EventList> lists;
  std::deque<Processor> machines;
  for (const Engine engine : {Engine::decoupled, Engine::lockstep}) {
    SimulationOptions options;
    options.engine = engine;
    options.max_cycles = 3000;
    lists.emplace_back(machines.emplace_back(("machine_" + std::to_string(machines.size())).c_str(),
                                             random_scene(3, {30, 30, 0}, 16, 100), MachineSpec{}, options));
  }
  sc_core::sc_start();
  for (const EventList& list : lists) {
    EXPECT_FALSE(list.machine().complete());
    expect_ordered(list);
    for (const Stage* stage : list.machine().stages()) {
      EXPECT_EQ(list.of(Event::Kind::firing, stage->basename()).back().until, stage->ready()) << stage->name();
    }
  }
}

/// Those that do not need the order are told of the same reads and writes, each FIFO's in order, whoever else listens.
TEST(EventStream, TellsSinksThatNeedNoOrderTheSame) {
  struct Early final : EventSink {
    std::vector<Event> events;
    bool in_order() const override { return false; }
    void take(const Event& event) override {
      events.push_back(event);
      events.back().subject = {};  // of which only those in order are told
    }
  } with_others, alone;
  Simulation simulation;
  const Scene scene = random_scene(3, {30, 30, 0}, 16, 60);
  Processor& machine = simulation.add(scene, {}, {});
  machine.attach(with_others);
  const EventList list(machine);
  simulation.add(scene, {}, {}).attach(alone);
  simulation.run();
  std::vector<Event> expected;
  for (Event event : list.all()) {
    event.subject = {};
    if (event.kind != Event::Kind::firing) expected.push_back(event);
  }
  for (std::vector<Event>* events : {&with_others.events, &alone.events}) {
    std::map<std::pair<Event::Kind, std::uint32_t>, Cycle> last;
    for (const Event& event : *events) {
      const auto [at, first] = last.try_emplace({event.kind, event.source}, event.at);
      EXPECT_TRUE(first || at->second < event.at);
      at->second = event.at;
    }
    std::sort(events->begin(), events->end());
    EXPECT_TRUE(*events == expected);
  }
}

/// Three sources in any order of reporting.
TEST(EventStream, OrdersByDateKindAndSourceUpToTheWatermark) {
  struct List final : EventSink {
    std::vector<Event> events;
    void take(const Event& event) override { events.push_back(event); }
  } list;
  EventStream stream;
  stream.attach(list);
  const EventPort zero(stream, 0);
  const EventPort one(stream, 1);
  one.write(5, 8, {});
  one.write(6, 9, {});
  zero.write(5, 8, {});
  one.read(5);
  zero.firing(StageState::starved, 3, 2, 5, 9);
  zero.write(7, 10, {});
  stream.release(6);
  ASSERT_EQ(list.events.size(), 4U);
  EXPECT_EQ(list.events[0], (Event{.kind = Event::Kind::read, .source = 1, .at = 5}));
  EXPECT_EQ(list.events[1], (Event{Event::Kind::firing, StageState::starved, 0, 3, 5, 2, 9, {}}));
  EXPECT_EQ(list.events[2], (Event{.kind = Event::Kind::write, .source = 0, .at = 5, .until = 8}));
  EXPECT_EQ(list.events[3], (Event{.kind = Event::Kind::write, .source = 1, .at = 5, .until = 8}));
  stream.release(7);
  ASSERT_EQ(list.events.size(), 5U);
  EXPECT_EQ(list.events[4].at, 6U);
  stream.release(never);
  EXPECT_EQ(list.events.size(), 6U);
  EXPECT_EQ(stream.peak(), 6U);
}

}  // namespace
}  // namespace pyrasim::hw
