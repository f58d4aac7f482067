// SPDX-License-Identifier: Apache-2.0
// The cycle loop by itself, on frames worked out on paper, and the Processor against it.
#include "cycle_loop.h"

#include <gtest/gtest.h>

#include "../test_scenes.h"
#include "random_machine.h"
#include "simulation.h"
#include "timeline.h"

namespace pyrasim::hw {
namespace {

/// Whether the Processor dispatches as MachineSpec says; if not, it is compared under round_robin only.
constexpr bool processor_has_dispatch = false;

constexpr int machines_per_case = 10;

class CycleLoopAndProcessor : public testing::TestWithParam<std::uint64_t> {};

struct Case {
  Scene scene;
  MachineSpec spec;
  SimulationOptions options;
};

Case random_case(std::mt19937_64& random) {
  Case result;
  const auto columns = static_cast<int>(1 + random() % 12);
  const auto rows = static_cast<int>(1 + random() % 8);
  const int objects = random() % 8 == 0 ? 0 : 10;
  result.scene = random_scene(random(), {objects, objects, random() % 4 == 0 ? 1 : 0}, columns, rows);
  result.options.max_level = static_cast<int>(random() % 6);
  result.options.scalar = random() % 4 == 0 ? ScalarFormat::single_precision : ScalarFormat::double_precision;
  result.spec = random_machine(random, result.options.max_level);
  if (!processor_has_dispatch) result.spec.dispatch = Dispatch::round_robin;
  return result;
}

TEST_P(CycleLoopAndProcessor, AgreeInEveryDateOfEveryFifo) {
  std::mt19937_64 random(GetParam());
  Simulation simulation;
  std::vector<Case> cases;
  std::deque<TimelineRecorder> decoupled;
  std::deque<TimelineRecorder> lockstep;
  for (int k = 0; k < machines_per_case; ++k) {
    Case& next = cases.emplace_back(random_case(random));
    decoupled.emplace_back(simulation.add(next.scene, next.spec, next.options));
    next.options.engine = Engine::lockstep;
    lockstep.emplace_back(simulation.add(next.scene, next.spec, next.options));
  }
  simulation.run();
  for (std::size_t k = 0; k < cases.size(); ++k) {
    SCOPED_TRACE("seed " + std::to_string(GetParam()) + ", machine " + std::to_string(k));
    const Case& its = cases[k];
    const Timeline loop = run_cycle_loop(its.scene, its.spec, its.options.max_level, its.options.scalar);
    EXPECT_EQ(FirstDifference(loop, decoupled[k].timeline()).text(), "") << "cycle loop against decoupled";
    EXPECT_EQ(FirstDifference(loop, lockstep[k].timeline()).text(), "") << "cycle loop against lockstep";
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, CycleLoopAndProcessor, testing::Range<std::uint64_t>(1, 21),
                         [](const auto& test) { return std::to_string(test.param); });

}  // namespace
}  // namespace pyrasim::hw
