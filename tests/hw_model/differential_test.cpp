// SPDX-License-Identifier: Apache-2.0
// Machines at random: the decoupled engine against lockstep, which is plain SystemC.
#include <gtest/gtest.h>

#include <random>

#include "../test_scenes.h"
#include "../windows.h"
#include "random_machine.h"
#include "simulation.h"

namespace pyrasim::hw {
namespace {

constexpr int machines_per_case = 10;

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
    Scene scene = random_scene(
        random(),
        {12, 12, k % 4 == 0 ? 1 : 0, k % 3 == 0 ? 5 : 0, k % 5 == 0 ? 5 : 0, k % 4 == 1 ? 8 : 0, 0, k % 4 == 2 ? 6 : 0},
        columns, rows);
    if (k % 2 == 0) scene = under_lights(std::move(scene), random);
    if (k % 3 == 1) scene = with_textures(std::move(scene), random);
    if (k % 3 == 0) scene.camera.window = random_window(random, scene.camera.screen);
    SimulationOptions options;
    options.max_level = static_cast<int>(random() % 6);
    options.edge = random() % 2 == 0 ? EdgePolicy::mean : EdgePolicy::drop;
    if (random() % 4 == 0) options.formats.intersection = NumberFormat::single();
    if (random() % 4 == 0) options.formats.view_vectors = tf32;
    const MachineSpec spec = random_machine(random, options.max_level);
    Processor& decoupled = simulation.add(scene, spec, options);
    options.engine = Engine::lockstep;
    runs.push_back({&decoupled, &simulation.add(scene, spec, options), reference(scene, options)});
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

/// Both engines on one machine, for each of `specs`, on a small frame with many edges.
void expect_engines_agree(const std::vector<MachineSpec>& specs, int max_level) {
  const Scene scene = random_scene(12, {20, 20, 0}, 16, 12);
  Simulation simulation;
  std::vector<std::pair<Processor*, Processor*>> pairs;
  for (const MachineSpec& spec : specs) {
    SimulationOptions options;
    options.max_level = max_level;
    Processor& decoupled = simulation.add(scene, spec, options);
    options.engine = Engine::lockstep;
    pairs.emplace_back(&decoupled, &simulation.add(scene, spec, options));
  }
  simulation.run();
  for (const auto& [decoupled, lockstep] : pairs) {
    expect_sound(*decoupled);
    expect_same_time(*decoupled, *lockstep);
  }
}

/// The classifier's read of a parent makes room for the controller long before its own result comes out. Corners are
/// waiting all the while, so that the generator must not run ahead of the request that follows.
TEST(Engines, AgreeWhereASlowClassifierFreesTheControllerEarly) {
  std::vector<MachineSpec> specs;
  for (const Cycle classifier : {1, 2, 3, 64}) {
    for (const Cycle intersection : {1, 2, 3, 8, 9, 30, 31}) {
      MachineSpec spec = with_all_fifos({}, 64);
      spec.fifos.subdivision_controller_to_pyramid_classifier = 1;
      spec.view_vector_generator = {.latency = 1, .interval = 2};
      spec.intersection_latency = intersection;
      spec.intersection_cost = {1, 0, {0, 0, 0}};
      spec.pyramid_classifier.latency = classifier;
      specs.push_back(spec);
    }
  }
  expect_engines_agree(specs, 3);
}

/// A stage can be busy for longer than it takes its last result to reach the frame buffer.
TEST(Engines, AgreeWhereAStageIsBusyAfterTheLastPixel) {
  std::vector<MachineSpec> specs(6);
  specs[0].pixel_scan.interval = 200;
  specs[1].view_vector_generator.interval = 200;
  specs[2].pyramid_classifier.interval = 200;
  specs[3].subdivision_controller.interval = 200;
  specs[4].tree_accumulator.interval = 200;
  specs[5].color_unit.interval = 200;
  expect_engines_agree(specs, 2);
}

/// A second thread of the host traces ahead, and changes nothing.
TEST(Engines, DoNotDependOnTheHostsThreads) {
  Simulation simulation;
  std::vector<std::pair<Processor*, Processor*>> pairs;
  for (const auto& [columns, rows] : {std::pair{1, 1}, {1, 40}, {40, 1}, {32, 24}}) {
    for (const int max_level : {0, 3}) {
      const Scene scene = random_scene(12, {20, 20, 0}, columns, rows);
      for (const std::size_t units : {1, 16}) {
        MachineSpec spec = with_all_fifos({}, 64);
        spec.intersection_units = units;
        spec.dispatch = max_level == 0 ? Dispatch::round_robin : Dispatch::first_free;
        SimulationOptions options;
        options.max_level = max_level;
        Processor& one = simulation.add(scene, spec, options);
        options.threads = 2;
        pairs.emplace_back(&one, &simulation.add(scene, spec, options));
      }
    }
  }
  simulation.run();
  for (const auto& [one, two] : pairs) {
    expect_same_time(*one, *two);
    EXPECT_TRUE(one->image().pixels() == two->image().pixels());
    EXPECT_EQ(one->statistics().work, two->statistics().work);
  }
}

}  // namespace
}  // namespace pyrasim::hw
