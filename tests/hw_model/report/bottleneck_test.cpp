// SPDX-License-Identifier: Apache-2.0
#include "hw_model/report/bottleneck.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <set>

#include "../../test_scenes.h"
#include "../random_machine.h"
#include "../simulation.h"

namespace pyrasim::hw {
namespace {

SimulationOptions at_level(int max_level) {
  SimulationOptions options;
  options.max_level = max_level;
  return options;
}

Scene scene_with_edges() { return random_scene(31, {12, 12, 0}, 10, 8); }

std::vector<Processor*> random_machines(Simulation& simulation) {
  std::mt19937_64 random(11);
  std::vector<Processor*> machines;
  for (int k = 0; k < 30; ++k) {
    const int max_level = static_cast<int>(random() % 5);
    machines.push_back(&simulation.add(random_scene(random(), {10, 10, 0}, 6, 5), random_machine(random, max_level),
                                       at_level(max_level)));
  }
  simulation.run();
  return machines;
}

TEST(Waits, AddUpToWhatTheStageWasStarvedAndBlocked) {
  Simulation simulation;
  for (const Processor* machine : random_machines(simulation)) {
    for (const Stage* stage : machine->stages()) {
      Cycle starved = 0;
      Cycle blocked = 0;
      for (const Wait& wait : waits(*machine, *stage)) (wait.starved ? starved : blocked) += wait.cycles;
      const StageStatistics statistics = stage->statistics(machine->cycles());
      EXPECT_EQ(starved, statistics.starved) << stage->name();
      EXPECT_EQ(blocked, statistics.blocked) << stage->name();
    }
  }
}

TEST(Waits, ComeLongestFirstAndOnlyWhereThereAreSome) {
  Simulation simulation;
  for (const Processor* machine : random_machines(simulation)) {
    for (const Stage* stage : machine->stages()) {
      Cycle before = never;
      for (const Wait& wait : waits(*machine, *stage)) {
        EXPECT_GT(wait.cycles, 0U);
        EXPECT_LE(wait.cycles, before);
        before = wait.cycles;
      }
    }
  }
}

TEST(BottleneckChain, EndsAtTheStageThatIsSlow) {
  constexpr Cycle slow = 50;
  const std::vector<std::pair<std::string, std::function<void(MachineSpec&)>>> cases{
      {"pixel_scan", [](MachineSpec& spec) { spec.pixel_scan.interval = 500; }},
      {"view_vector_generator", [](MachineSpec& spec) { spec.view_vector_generator.interval = slow; }},
      {"intersection_units", [](MachineSpec& spec) { spec.intersection_cost.ray = 500; }},
      {"pyramid_classifier", [](MachineSpec& spec) { spec.pyramid_classifier.interval = slow; }},
      {"subdivision_controller", [](MachineSpec& spec) { spec.subdivision_controller.interval = 200; }},
      {"color_unit", [](MachineSpec& spec) { spec.color_unit.interval = slow; }},
      {"tree_accumulator", [](MachineSpec& spec) { spec.tree_accumulator.interval = slow; }},
      {"frame_buffer", [](MachineSpec& spec) { spec.frame_buffer_interval = 500; }}};
  Simulation simulation;
  std::vector<const Processor*> machines;
  for (const auto& [unit, change] : cases) {
    MachineSpec spec;
    change(spec);
    machines.push_back(&simulation.add(scene_with_edges(), spec, at_level(3)));
  }
  simulation.run();
  for (std::size_t k = 0; k < cases.size(); ++k) {
    const std::vector<BottleneckLink> chain = bottleneck_chain(*machines[k]);
    SCOPED_TRACE(bottleneck_text(chain));
    EXPECT_EQ(chain.front().unit, "tree_accumulator");
    EXPECT_EQ(chain.back().unit, cases[k].first);
    const auto is_slow = [&](const BottleneckLink& link) { return link.unit == cases[k].first; };
    EXPECT_EQ(std::count_if(chain.begin(), chain.end(), is_slow), 1) << "the chain ends here, it does not close";
    EXPECT_EQ(chain.back().waited, 0);
    EXPECT_EQ(lower_bound(*machines[k]).unit, cases[k].first);
    EXPECT_NE(bottleneck_text(chain).find(cases[k].first + " busy"), std::string::npos);
  }
}

/// The accumulator is busy for longer than it waits, but the unit is busier: without it the frame would be shorter.
TEST(BottleneckChain, GoesOnFromABoxThatIsNotTheBusiest) {
  MachineSpec spec;
  spec.intersection_units = 1;
  spec.intersection_cost = {10, 0, {0, 0, 0}};
  spec.tree_accumulator.interval = 8;
  Simulation simulation;
  const Processor& machine = simulation.add(empty_scene(40, 30, 0.1), spec, at_level(0));
  simulation.run();
  const std::vector<BottleneckLink> chain = bottleneck_chain(machine);
  SCOPED_TRACE(bottleneck_text(chain));
  ASSERT_EQ(chain.size(), 4U);
  EXPECT_GT(chain[0].busy, chain[0].waited);
  EXPECT_EQ(chain[1].unit, "color_unit");
  EXPECT_EQ(chain[2].unit, "pyramid_classifier");
  EXPECT_EQ(chain[3].unit, "intersection_units");
  EXPECT_GT(chain[3].busy, chain[0].busy);
}

/// Nobody is busy: each waits for the next all the way round, and the latency of the loop is the cause.
TEST(BottleneckChain, ClosesWithOneSlotInFlight) {
  MachineSpec spec;
  spec.pixels_in_flight = 1;
  Simulation simulation;
  const Processor& machine = simulation.add(empty_scene(10, 8, 0.1), spec, at_level(0));
  simulation.run();
  const std::vector<BottleneckLink> chain = bottleneck_chain(machine);
  SCOPED_TRACE(bottleneck_text(chain));
  std::vector<std::string> units;
  for (const BottleneckLink& link : chain) units.push_back(link.unit);
  EXPECT_EQ(units,
            (std::vector<std::string>{"tree_accumulator", "color_unit", "pyramid_classifier", "intersection_units",
                                      "view_vector_generator", "pixel_scan", "tree_accumulator"}));
  for (std::size_t k = 0; k + 1 < chain.size(); ++k) {
    EXPECT_TRUE(chain[k].starved);
    EXPECT_GT(chain[k].waited, 0.5);
  }
}

TEST(BottleneckChain, EndsAndNamesNoBoxTwiceButTheLast) {
  Simulation simulation;
  for (const Processor* machine : random_machines(simulation)) {
    const std::vector<BottleneckLink> chain = bottleneck_chain(*machine);
    std::set<std::string> units;
    for (std::size_t k = 0; k + 1 < chain.size(); ++k) {
      EXPECT_TRUE(units.insert(chain[k].unit).second) << bottleneck_text(chain);
      EXPECT_GT(chain[k].waited, 0) << bottleneck_text(chain);
      EXPECT_LE(chain[k].waited, 1) << bottleneck_text(chain);
    }
  }
}

TEST(BottleneckChain, TakesTheUnitsForOneBox) {
  MachineSpec spec;
  spec.intersection_units = 5;
  spec.intersection_cost.ray = 100;
  Simulation simulation;
  const Processor& machine = simulation.add(scene_with_edges(), spec, at_level(3));
  simulation.run();
  double busy = 0;
  for (int k = 0; k < 5; ++k) {
    busy += static_cast<double>(stage_statistics(machine, "intersection_unit_" + std::to_string(k)).busy);
  }
  const BottleneckLink last = bottleneck_chain(machine).back();
  EXPECT_EQ(last.unit, "intersection_units");
  EXPECT_NEAR(last.busy, busy / 5 / static_cast<double>(machine.cycles()), 1e-12);
}

TEST(LowerBound, IsNoMoreThanTheFramesCyclesAndTheMostBusyUnitsWork) {
  Simulation simulation;
  for (const Processor* machine : random_machines(simulation)) {
    const LowerBound bound = lower_bound(*machine);
    EXPECT_LE(bound.cycles, machine->cycles()) << bound.unit;
    Cycle most = 0;
    Cycle intersection = 0;
    for (const Stage* stage : machine->stages()) {
      const Cycle busy = stage->statistics(machine->cycles()).busy;
      const bool unit = std::string(stage->basename()).rfind("intersection_unit", 0) == 0;
      (unit ? intersection : most) = unit ? intersection + busy : std::max(most, busy);
    }
    const Cycle units = machine->spec().intersection_units;
    EXPECT_EQ(bound.cycles, std::max(most, (intersection + units - 1) / units)) << bound.unit;
  }
}

/// One unit, and all else hidden behind it: the frame takes hardly longer than its work.
TEST(LowerBound, IsNearlyReachedByALoneSlowUnit) {
  MachineSpec spec;
  spec.intersection_units = 1;
  spec.intersection_cost.ray = 100;
  Simulation simulation;
  const Processor& machine = simulation.add(scene_with_edges(), spec, at_level(0));
  simulation.run();
  const LowerBound bound = lower_bound(machine);
  EXPECT_EQ(bound.cycles, stage_statistics(machine, "intersection_unit_0").busy);
  // Scan and generator before the first ray, 1 + 4; after the last the unit's latency less 1, classifier, colour unit,
  // accumulator, and the frame buffer's cycle.
  EXPECT_EQ(machine.cycles(), bound.cycles + 1 + 4 + 7 + 2 + 1 + 2 + 1);
}

}  // namespace
}  // namespace pyrasim::hw
