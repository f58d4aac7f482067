// SPDX-License-Identifier: Apache-2.0
#include "hw_model/report/deadlock.h"

#include <gtest/gtest.h>

#include <optional>

#include "../../error_of.h"
#include "../../test_scenes.h"
#include "../cycle_loop.h"
#include "../simulation.h"
#include "error.h"

namespace pyrasim::hw {
namespace {

constexpr int max_level = 4;

Scene scene_with_edges() { return random_scene(31, {12, 12, 0}, 10, 8); }

class Deadlock : public testing::TestWithParam<Engine> {
 protected:
  SimulationOptions options() const {
    SimulationOptions options;
    options.max_level = max_level;
    options.engine = GetParam();
    return options;
  }
  /// With a pool that lacks `missing` entries of the least, and so few slots that the scan is part of the circle.
  Processor& machine(std::size_t missing) {
    MachineSpec spec;
    spec.subdivision_pool = required_pool(max_level) - missing;
    spec.pixels_in_flight = 8;
    SimulationOptions unchecked = options();
    unchecked.check_machine = false;
    return processor_.emplace("machine", scene_with_edges(), spec, unchecked);
  }

 private:
  std::optional<Processor> processor_;
};

TEST_P(Deadlock, APoolThatLacksOneEntryStandsStill) {
  Processor& stuck = machine(1);
  sc_core::sc_start();
  EXPECT_FALSE(stuck.complete());
  EXPECT_TRUE(stuck.at_rest());
}

TEST_P(Deadlock, TheSmallestPoolDoesNot) {
  Processor& finished = machine(0);
  sc_core::sc_start();
  EXPECT_TRUE(finished.complete());
  EXPECT_EQ(why_unfinished(finished), "");
}

TEST_P(Deadlock, IsReportedWithTheCircleAndEveryStageAndFifo) {
  Processor& stuck = machine(1);
  sc_core::sc_start();
  const std::string why = why_unfinished(stuck);
  EXPECT_EQ(why.rfind("deadlock: no stage can go on; in a circle: ", 0), 0U) << why;
  const std::string circle = wait_for_cycle(stuck);
  EXPECT_NE(why.find("circle: " + circle + "\n"), std::string::npos) << why;
  EXPECT_NE(circle.find("pixel_scan -> tree_accumulator"), std::string::npos) << circle;
  EXPECT_EQ(circle.substr(0, circle.find(" -> ")), circle.substr(circle.rfind(" -> ") + 4)) << circle;
  for (const Stage* stage : stuck.stages()) {
    EXPECT_NE(why.find("\n  " + std::string(stage->basename()) + ": ready at "), std::string::npos) << why;
  }
  for (const FifoBase* fifo : stuck.fifos()) {
    const std::string line = std::string(fifo->basename()) + ": " + std::to_string(fifo->size()) + " of " +
                             std::to_string(fifo->statistics().depth) + "\n";
    EXPECT_NE(why.find("\n  " + line), std::string::npos) << why;
  }
  EXPECT_NE(why.find("waits for a token from tree_accumulator_to_pixel_scan"), std::string::npos) << why;
}

/// It waits for the classifier to close a family, but the reader of the report wants to know why.
TEST_P(Deadlock, TheControllersLineSaysThatItsPoolHasNoRoom) {
  Processor& stuck = machine(1);
  sc_core::sc_start();
  const std::string state = machine_state(stuck);
  EXPECT_NE(state.find(", has no room in its pool: 0 of 9 entries kept, 10 more needed\n"), std::string::npos) << state;
  EXPECT_EQ(state.find("a token from pyramid_classifier_to_subdivision_controller"), std::string::npos) << state;
}

/// The scan is through, so that nobody waits for anybody in a circle; still no stage can go on.
TEST_P(Deadlock, WithoutACircleIsADeadlockAllTheSame) {
  MachineSpec spec;
  spec.subdivision_pool = required_pool(max_level) - 1;
  SimulationOptions unchecked = options();
  unchecked.check_machine = false;
  Processor stuck("machine", scene_with_edges(), spec, unchecked);
  sc_core::sc_start();
  ASSERT_TRUE(stuck.at_rest());
  EXPECT_EQ(wait_for_cycle(stuck), "");
  const std::string why = why_unfinished(stuck);
  EXPECT_EQ(why.rfind("deadlock: no stage can go on\n", 0), 0U) << why;
  EXPECT_NE(why.find(", has nothing to do\n  view_vector_generator: "), std::string::npos) << why;
}

TEST_P(Deadlock, IsRefusedBeforeTheRunWhereTheMachineIsChecked) {
  MachineSpec spec;
  spec.subdivision_pool = required_pool(max_level) - 1;
  const std::string error =
      error_of<InputError>([&] { const Processor refused("machine", scene_with_edges(), spec, options()); });
  EXPECT_NE(error.find("at least 10 = 3 (4 - 1) + 1 is needed"), std::string::npos) << error;
}

/// The frame's cycles are enough, and one less is not. SystemC runs once a process, so the cycle loop says how many.
TEST_P(Deadlock, MaxCyclesLimitTheFrameToTheCycle) {
  const Scene scene = scene_with_edges();
  const Cycle cycles = run_cycle_loop(scene, {}, max_level).cycles;
  SimulationOptions limited = options();
  limited.max_cycles = cycles;
  Processor enough("enough", scene, {}, limited);
  limited.max_cycles = cycles - 1;
  Processor short_of_one("short_of_one", scene, {}, limited);
  limited.max_cycles = cycles / 2;
  Processor half("half", scene, {}, limited);
  sc_core::sc_start();
  EXPECT_EQ(why_unfinished(enough), "");
  EXPECT_EQ(enough.cycles(), cycles);
  for (Processor* machine : {&short_of_one, &half}) {
    const std::string why = why_unfinished(*machine);
    const std::string reason =
        "the frame is not finished within " + std::to_string(machine->max_cycles()) + " cycles\n";
    EXPECT_EQ(why.rfind(reason, 0), 0U) << why;
    EXPECT_NE(why.find("\n  frame_buffer: ready at "), std::string::npos) << why;
  }
  EXPECT_FALSE(half.complete());
}

INSTANTIATE_TEST_SUITE_P(Engines, Deadlock, testing::Values(Engine::decoupled, Engine::lockstep),
                         [](const auto& test) { return test.param == Engine::decoupled ? "decoupled" : "lockstep"; });

}  // namespace
}  // namespace pyrasim::hw
