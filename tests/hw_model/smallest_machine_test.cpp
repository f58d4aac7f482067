// SPDX-License-Identifier: Apache-2.0
// The smallest machines that are allowed finish every frame.
#include <gtest/gtest.h>

#include "../test_scenes.h"
#include "simulation.h"

namespace pyrasim::hw {
namespace {

MachineSpec smallest(int max_level, std::size_t units) {
  MachineSpec spec = with_all_fifos({}, 1);
  spec.intersection_units = units;
  spec.pixels_in_flight = 1;
  spec.subdivision_pool = required_pool(max_level);
  return spec;
}

class SmallestMachine : public testing::TestWithParam<int> {};

TEST_P(SmallestMachine, FinishesWithTheReferencesResults) {
  const int max_level = GetParam();
  const Scene scene = random_scene(77, {15, 15, 0}, 5, 4);
  Simulation simulation;
  std::vector<std::pair<Processor*, Processor*>> pairs;
  for (const std::size_t units : {1, 3}) {
    SimulationOptions options;
    options.max_level = max_level;
    Processor& decoupled = simulation.add(scene, smallest(max_level, units), options);
    options.engine = Engine::lockstep;
    if (max_level > 7) options.engine = Engine::decoupled;
    pairs.emplace_back(&decoupled, &simulation.add(scene, smallest(max_level, units), options));
  }
  simulation.run();
  const Rendering expected = reference(scene, max_level);
  EXPECT_GT(expected.statistics.subdivisions + (max_level == 0 ? 1 : 0), 0U);
  for (const auto& [a, b] : pairs) {
    expect_results(*a, expected);
    expect_sound(*a);
    expect_same_time(*a, *b);
    if (max_level >= 2) {
      EXPECT_GE(a->controller()->pool_max(), 4U);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(MaxLevel, SmallestMachine, testing::Range(0, 11),
                         [](const auto& test) { return std::to_string(test.param); });

/// The least pool with everything else roomy: only the banker's rule holds requests back.
TEST(SmallestPool, RoomyMachineWithTheLeastPool) {
  const Scene scene = random_scene(78, {60, 60, 0}, 12, 9);
  Simulation simulation;
  std::vector<Processor*> machines;
  for (const std::size_t extra : {0, 1, 2, 3, 100}) {
    MachineSpec spec = with_all_fifos({}, 64);
    spec.subdivision_pool = required_pool(6) + extra;
    SimulationOptions options;
    options.max_level = 6;
    machines.push_back(&simulation.add(scene, spec, options));
  }
  simulation.run();
  const Rendering expected = reference(scene, 6);
  for (const Processor* machine : machines) {
    expect_results(*machine, expected);
    expect_sound(*machine);
  }
}

TEST(EmptyScene, NeedsNoControllerAndFinishes) {
  const Scene scene = empty_scene(9, 7, 0.125);
  Simulation simulation;
  SimulationOptions options;
  options.max_level = 0;
  const Processor& flat = simulation.add(scene, smallest(0, 1), options);
  options.max_level = 5;
  const Processor& deep = simulation.add(scene, {}, options);
  simulation.run();
  for (const Processor* machine : {&flat, &deep}) {
    EXPECT_EQ(machine->controller(), nullptr);
    EXPECT_EQ(machine->statistics().total_rays(), 80U);
    EXPECT_EQ(machine->statistics().terminal_nodes, 63U);
    expect_sound(*machine);
    EXPECT_TRUE(machine->image().pixels() == reference(scene, 0).image.pixels());
    bool told = false;
    for (const MachinePart& part : machine->parts()) told |= part.name() == "subdivision_controller" && part.units == 0;
    EXPECT_TRUE(told);
  }
}

}  // namespace
}  // namespace pyrasim::hw
