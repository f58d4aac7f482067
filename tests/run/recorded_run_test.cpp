// SPDX-License-Identifier: Apache-2.0
#include "run/recorded_run.h"

#include <gtest/gtest.h>

#include "../shipped_scene.h"

namespace pyrasim {
namespace {

/// A scene's frame as it is simulated and recorded.
struct Frame {
  std::shared_ptr<const Scene> scene;
  Task task;

  explicit Frame(const std::string& name) {
    Scene seen = shipped_scene(name);
    task.run.screen = seen.camera.screen = resized(seen.camera.screen, 40, 30);
    task.scene = scene = std::make_shared<const Scene>(std::move(seen));
    task.intersector = make_intersector(*scene);
  }
  RecordedRun recorded() const {
    const auto [outcome, work] = execute_recorded(task, "the simulation", SIZE_MAX);
    return recorded_run(task.run, *scene, task.intersector->contents(), outcome, work.value());
  }
};

void expect_same(const Task& simulated, const Task& replayed) {
  Outcome expected = execute(simulated, "the simulation");
  Outcome found = execute(replayed, "the replay");
  expected.host_seconds = found.host_seconds = 0;
  EXPECT_EQ(found, expected);
}

hw::MachineSpec another_machine() {
  hw::MachineSpec machine;
  machine.intersection_units = 7;
  machine.dispatch = hw::Dispatch::first_free;
  machine.fifos.intersection_unit_to_pyramid_classifier = 2;
  return machine;
}

TEST(RecordedRun, OfATaskIsThatOfTheScene) {
  for (const char* name : {"keel", "shadows", "buoys"}) {
    SCOPED_TRACE(name);
    const Frame frame(name);
    Task other = frame.task;
    other.run.machine = another_machine();
    expect_same(other, frame.recorded().on(other.run.machine));
  }
}

/// A frame's rays are some of those of a higher level.
TEST(RecordedRun, HoldsTheRaysOfLowerLevels) {
  for (const char* name : {"keel", "shadows"}) {
    for (const int level : {0, 1, 2}) {
      SCOPED_TRACE(level);
      const Frame frame(name);
      Task lower = frame.task;
      lower.run.max_level = level;
      Task replayed = frame.recorded().on(another_machine());
      lower.run.machine = another_machine();
      replayed.run.max_level = level;
      EXPECT_EQ(execute(replayed, "the replay").cycles, execute(lower, "the simulation").cycles);
    }
  }
}

TEST(RecordedRun, IsNotMadeOfWhatIsTooLargeOrUnfinished) {
  Frame frame("keel");
  EXPECT_TRUE(execute_recorded(frame.task, "the simulation", 1U << 20U).work);
  EXPECT_FALSE(execute_recorded(frame.task, "the simulation", 1000).work);
  frame.task.run.max_cycles = 100;
  const auto [outcome, work] = execute_recorded(frame.task, "the simulation", SIZE_MAX);
  EXPECT_FALSE(work);
  EXPECT_NE(outcome.unfinished, "");
}

}  // namespace
}  // namespace pyrasim
