// SPDX-License-Identifier: Apache-2.0
#include "hw_model/trace/vcd_trace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <map>
#include <random>
#include <sstream>

#include "../../temporary_folder.h"
#include "../../test_scenes.h"
#include "../event_list.h"
#include "../random_machine.h"
#include "../simulation.h"

namespace pyrasim::hw {
namespace {

TEST(VcdTime, IsInTheLargestUnitThatMakesTheCycleAWholeNumber) {
  struct Case {
    double clock_mhz;
    const char* unit;
    std::uint64_t steps;
  };
  for (const auto& [clock_mhz, unit, steps] : {Case{200, "1 ns", 5},
                                               {1000, "1 ns", 1},
                                               {1, "1 us", 1},
                                               {100, "10 ns", 1},
                                               {10, "100 ns", 1},
                                               {400, "100 ps", 25},
                                               {250, "1 ns", 4},
                                               {0.001, "1 ms", 1},
                                               {0.25, "1 us", 4},
                                               {1e6, "1 ps", 1},
                                               {160, "10 ps", 625},
                                               {512, "1 fs", 1953125}}) {
    SCOPED_TRACE(clock_mhz);
    const VcdTime time(clock_mhz);
    EXPECT_EQ(time.unit(), unit);
    for (const Cycle cycle : {Cycle{0}, Cycle{1}, Cycle{7}, Cycle{1'000'000'007}}) {
      EXPECT_EQ(time.date(cycle), cycle * steps);
    }
  }
}

/// 333 MHz: 3003003.003... fs. Rounded once, the dates do not drift.
TEST(VcdTime, IsRoundedWhereThereIsNoSuchUnit) {
  const VcdTime time(333);
  EXPECT_EQ(time.unit(), "1 fs");
  for (const Cycle cycle : {Cycle{0}, Cycle{1}, Cycle{2}, Cycle{166}, Cycle{167}, Cycle{333}, Cycle{1'000'000'007}}) {
    EXPECT_EQ(time.date(cycle), (2 * cycle * 1'000'000'000 + 333) / (2 * 333)) << cycle;
  }
  const VcdTime slow(0.75);
  EXPECT_EQ(slow.unit(), "1 ps");
  EXPECT_EQ(slow.date(1), 1'333'333U);
  EXPECT_EQ(slow.date(2), 2'666'667U);
  EXPECT_EQ(slow.date(3'000'000'000'000), 4'000'000'000'000'000'000U);
}

constexpr unsigned long unknown = no_number;  // x

/// The value of every signal in every cycle, by its name, as a VCD file of one step a cycle says.
std::map<std::string, std::vector<unsigned long>> read_vcd(const std::string& text, Cycle cycles) {
  std::map<std::string, std::string> names;
  std::map<std::string, std::vector<unsigned long>> values;
  std::map<std::string, unsigned long> now;
  Cycle at = 0;
  const auto go_to = [&](Cycle next) {
    for (; at < next; ++at) {
      for (const auto& [name, value] : now) values[name].push_back(value);
    }
  };
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (word == "$var") {
      std::string kind, bits, code, name;
      words >> kind >> bits >> code >> name;
      names[code] = name;
    } else if (word[0] == '#') {
      go_to(std::stoull(word.substr(1)));
    } else if (word == "bx" || (word[0] == 'b' && word.find_first_not_of("01", 1) == std::string::npos)) {
      std::string code;
      words >> code;
      const unsigned long value = word == "bx" ? unknown : std::stoul(word.substr(1), nullptr, 2);
      const auto [signal, first] = now.try_emplace(names.at(code), value);
      EXPECT_TRUE(first || signal->second != value) << names.at(code) << " does not change at " << at;
      signal->second = value;
    }
  }
  EXPECT_EQ(at, cycles);
  return values;
}

/// The same, counted from the events.
std::map<std::string, std::vector<unsigned long>> counted(const EventList& list,
                                                          const std::vector<std::size_t>& preloaded) {
  const Processor& machine = list.machine();
  const std::size_t cycles = machine.cycles();
  std::map<std::string, std::vector<unsigned long>> values;
  for (const Stage* stage : machine.stages()) {
    auto& states = values[stage->basename()];
    states.assign(cycles, 0);
    for (const Event& firing : list.of(Event::Kind::firing, stage->basename())) {
      std::fill(states.begin() + static_cast<long>(firing.since), states.begin() + static_cast<long>(firing.at),
                static_cast<unsigned long>(firing.waited));
      std::fill(states.begin() + static_cast<long>(firing.at), states.begin() + static_cast<long>(firing.until), 1UL);
    }
  }
  for (std::size_t k = 0; k < preloaded.size(); ++k) {
    const char* name = machine.fifos()[k]->basename();
    auto& fill = values[name];
    fill.assign(cycles, preloaded[k]);
    for (const Event& write : list.of(Event::Kind::write, name)) {
      for (std::size_t at = write.at; at < cycles; ++at) ++fill[at];
    }
    for (const Event& read : list.of(Event::Kind::read, name)) {
      for (std::size_t at = read.at + 1; at < cycles; ++at) --fill[at];
    }
  }
  return values;
}

/// The details, from the events.
std::map<std::string, std::vector<unsigned long>> counted_details(const EventList& list,
                                                                  const std::vector<std::size_t>& preloaded) {
  const Processor& machine = list.machine();
  const std::size_t cycles = machine.cycles();
  std::map<std::string, std::vector<unsigned long>> values;
  for (const Stage* stage : machine.stages()) {
    const std::string name = stage->basename();
    std::vector<unsigned long>& rows = values[name + "_row"];
    std::vector<unsigned long>& columns = values[name + "_column"];
    std::vector<unsigned long>& rays = values[name + "_ray"];
    for (std::vector<unsigned long>* all : {&rows, &columns, &rays}) all->assign(cycles, unknown);
    for (const Event& firing : list.of(Event::Kind::firing, name)) {
      for (std::size_t at = firing.at; at < cycles; ++at) {
        const bool has_pixel = firing.subject.pixel != no_pixel;
        const auto [row, column] = has_pixel ? machine.place_of(firing.subject.pixel) : std::pair(0, 0);
        rows[at] = has_pixel ? static_cast<unsigned long>(row) : unknown;
        columns[at] = has_pixel ? static_cast<unsigned long>(column) : unknown;
        rays[at] = firing.subject.ray;
      }
    }
  }
  for (std::size_t k = 0; k < preloaded.size(); ++k) {
    const std::string name = machine.fifos()[k]->basename();
    std::vector<std::size_t> readable(cycles, preloaded[k]);
    std::vector<std::size_t> taken = readable;  // cells, when the cycle begins
    for (const Event& write : list.of(Event::Kind::write, name)) {
      for (std::size_t at = write.until; at < cycles; ++at) ++readable[at];
      for (std::size_t at = write.at + 1; at < cycles; ++at) ++taken[at];
    }
    for (const Event& read : list.of(Event::Kind::read, name)) {
      for (std::size_t at = read.at + 1; at < cycles; ++at) --readable[at], --taken[at];
    }
    for (std::size_t at = 0; at < cycles; ++at) {
      values[name + "_valid"].push_back(readable[at] > 0 ? 1 : 0);
      values[name + "_ready"].push_back(taken[at] < machine.fifos()[k]->depth() ? 1 : 0);
    }
  }
  return values;
}

/// A FIFO is valid when it is read and ready when it is written, and a stage that waits for it waits while it is not.
void expect_handshakes(const EventList& list, const std::map<std::string, std::vector<unsigned long>>& values) {
  const Processor& machine = list.machine();
  for (const Event& event : list.all()) {
    if (event.kind != Event::Kind::firing) {
      const char* signal = event.kind == Event::Kind::read ? "_valid" : "_ready";
      EXPECT_EQ(values.at(list.name_of(event) + signal)[event.at], 1U) << list.name_of(event) << " at " << event.at;
    } else if (event.cause != no_fifo && event.waited != StageState::idle) {
      const std::string fifo = machine.fifos()[event.cause]->basename();
      const auto& signal = values.at(fifo + (event.waited == StageState::starved ? "_valid" : "_ready"));
      for (Cycle at = event.since; at < event.at; ++at) {
        EXPECT_EQ(signal[at], 0U) << list.name_of(event) << " waits for " << fifo << " at " << at;
      }
    }
  }
}

TraceWindow all_of_it() {
  TraceWindow window;
  window.detail = true;
  return window;
}

using VcdTraceTest = TemporaryFolder;

TEST_F(VcdTraceTest, HoldsEverySignalInEveryCycle) {
  struct Traced {
    std::vector<std::size_t> preloaded;
    EventList events;
    OutputFile output;
    VcdTrace vcd;
    Traced(Processor& machine, const std::filesystem::path& file)
        : events(machine), output(file), vcd(machine, all_of_it(), output) {
      for (const FifoBase* fifo : machine.fifos()) preloaded.push_back(fifo->size());
    }
  };
  std::mt19937_64 random(47);
  Simulation simulation;
  std::deque<Traced> machines;
  for (int k = 0; k < 12; ++k) {
    SimulationOptions options;
    options.max_level = static_cast<int>(random() % 4);
    options.engine = k % 2 == 0 ? Engine::decoupled : Engine::lockstep;
    MachineSpec spec = random_machine(random, options.max_level);
    spec.clock_mhz = 1000;  // a step is a cycle
    machines.emplace_back(simulation.add(random_scene(random(), {12, 12, 0}, 8, 6), spec, options),
                          in_folder(std::to_string(k) + ".vcd"));
  }
  simulation.run();
  for (Traced& traced : machines) {
    SCOPED_TRACE(traced.events.machine().name());
    traced.vcd.finish(traced.events.machine().cycles());
    traced.output.commit();
    const auto values = read_vcd(contents(traced.output.path()), traced.events.machine().cycles());
    auto expected = counted(traced.events, traced.preloaded);
    expected.merge(counted_details(traced.events, traced.preloaded));
    EXPECT_TRUE(values == expected);
    expect_handshakes(traced.events, values);
  }
}

/// What is undone is not there.
TEST_F(VcdTraceTest, LeavesNothingOfARunThatStops) {
  SimulationOptions options;
  options.max_cycles = 2000;
  {
    Processor machine("machine", random_scene(3, {30, 30, 0}, 16, 400), {}, options);
    OutputFile output(in_folder("out.vcd"));
    VcdTrace vcd(machine, {}, output);
    sc_core::sc_start();
    EXPECT_FALSE(machine.complete());
    EXPECT_GT(output.size(), 10'000U);
  }
  EXPECT_EQ(entries(), 0);
}

}  // namespace
}  // namespace pyrasim::hw
