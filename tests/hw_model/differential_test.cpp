// SPDX-License-Identifier: Apache-2.0
// Machines at random: the decoupled engine against lockstep, which is plain SystemC.
#include <gtest/gtest.h>

#include <random>

#include "../test_scenes.h"
#include "simulation.h"

namespace pyrasim::hw {
namespace {

constexpr int machines_per_case = 10;

MachineSpec random_machine(std::mt19937_64& random, int max_level) {
  const auto from = [&](std::uint64_t low, std::uint64_t high) { return low + random() % (high - low + 1); };
  const auto timing = [&] { return StageTiming{from(1, from(1, 64)), from(1, from(1, 8))}; };
  const auto depth = [&] { return static_cast<std::size_t>(from(1, from(1, 16))); };
  MachineSpec spec;
  spec.clock_mhz = 50.0 * static_cast<double>(from(1, 20));
  spec.pixel_scan = timing();
  spec.view_vector_generator = timing();
  spec.intersection_units = from(1, 16);
  spec.intersection_latency = from(1, 64);
  spec.intersection_cost = {from(1, 8), from(0, 4), {from(0, 8), from(0, 8), from(0, 8)}};
  spec.pyramid_classifier = timing();
  spec.subdivision_controller = timing();
  spec.subdivision_pool = required_pool(max_level) + from(0, from(0, 40));
  spec.tree_accumulator = timing();
  spec.pixels_in_flight = from(1, from(1, 300));
  spec.frame_buffer = timing();
  spec.fifos = {depth(), depth(), depth(), depth(), depth(), depth(), depth(), depth()};
  return spec;
}

class RandomMachines : public testing::TestWithParam<std::uint64_t> {};

TEST_P(RandomMachines, EnginesAgreeInEveryAccount) {
  const std::uint64_t seed = GetParam();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937_64 random(seed);
  Simulation simulation;
  struct Run {
    Processor* decoupled;
    Processor* lockstep;
    Rendering expected;
  };
  std::vector<Run> runs;
  for (int k = 0; k < machines_per_case; ++k) {
    const auto columns = static_cast<int>(1 + random() % 16);
    const auto rows = static_cast<int>(1 + random() % 12);
    const Scene scene = random_scene(random(), {12, 12, k % 4 == 0 ? 1 : 0}, columns, rows);
    SimulationOptions options;
    options.max_level = static_cast<int>(random() % 6);
    options.leaf = random() % 2 == 0 ? Leaf::mean : Leaf::drop;
    const MachineSpec spec = random_machine(random, options.max_level);
    Processor& decoupled = simulation.add(scene, spec, options);
    options.engine = Engine::lockstep;
    runs.push_back(
        {&decoupled, &simulation.add(scene, spec, options), reference(scene, options.max_level, options.leaf)});
  }
  simulation.run();
  for (const Run& run : runs) {
    expect_results(*run.decoupled, run.expected);
    expect_results(*run.lockstep, run.expected);
    expect_sound(*run.decoupled);
    expect_same_time(*run.decoupled, *run.lockstep);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomMachines, testing::Range<std::uint64_t>(1, 13),
                         [](const auto& test) { return std::to_string(test.param); });

}  // namespace
}  // namespace pyrasim::hw
