// SPDX-License-Identifier: Apache-2.0
#include "run/simulation.h"

#include <gtest/gtest.h>

#include "../error_of.h"
#include "../shipped_scene.h"
#include "error.h"
#include "image/image_error.h"
#include "image/image_hash.h"
#include "render/method.h"
#include "run/executor.h"

namespace pyrasim {
namespace {

struct SmallFrame {
  std::shared_ptr<const Scene> scene = std::make_shared<const Scene>(shipped_scene("keel"));
  Run run;

  SmallFrame() {
    run.screen = resized(scene->camera.screen, 64, 48);
    run.window = {8, 10, 40, 30};
    run.max_level = 2;
  }
  Rendering rendered() const {
    Scene seen = *scene;
    seen.camera.screen = run.screen;
    seen.camera.window = run.window;
    Method method;
    method.pyramids.max_level = run.max_level;
    return render(seen, method, {}, 1);
  }
};

/// The process that the executor makes it in sends all that this one would find.
TEST(Simulation, IsTheSameInAProcessOfItsOwn) {
  const SmallFrame frame;
  const Rendering rendering = frame.rendered();
  Task task{frame.run, frame.scene};
  task.measure = [&](const Simulation& finished, Outcome& outcome) {
    outcome.format_error = {
        changed_pixels(finished.image(), rendering.image), psnr(finished.image(), rendering.image), {1, 2, 3, 4}};
  };
  Outcome apart = execute(task, "the simulation");
  Outcome here = simulate(frame.run, *frame.scene, {}, task.measure);
  EXPECT_GT(apart.host_seconds, 0);
  EXPECT_GT(here.host_seconds, 0);
  apart.host_seconds = here.host_seconds = 0;
  EXPECT_EQ(apart, here);
  EXPECT_EQ(here.counts.total_rays(), rendering.statistics.total_rays());
  EXPECT_EQ(here.image_sha256, image_sha256(rendering.image));
  EXPECT_EQ(here.format_error->changed_pixels, 0U);
  EXPECT_EQ(here.format_error->psnr, std::numeric_limits<double>::infinity());
  EXPECT_EQ(here.units.size(), 11U);
  EXPECT_EQ(here.latency.pixels, 40U * 30U);
  for (const FifoAccount& fifo : here.fifos) EXPECT_TRUE(fifo.occupancy.tokens.empty());
}

TEST(Simulation, WatchesOccupancies) {
  const SmallFrame frame;
  Simulation simulation(frame.run, *frame.scene, {.occupancies = true});
  const Outcome outcome = simulation.run();
  for (const FifoAccount& fifo : outcome.fifos) {
    EXPECT_EQ(fifo.occupancy.tokens.size(), (outcome.cycles + fifo.occupancy.stride - 1) / fifo.occupancy.stride);
  }
}

TEST(Simulation, OfAFrameThatIsNotFinishedSaysWhy) {
  SmallFrame frame;
  frame.run.max_cycles = 10;
  Task task{frame.run, frame.scene};
  task.measure = [](const Simulation&, Outcome& outcome) { outcome.error = {1, 2, 3}; };
  const Outcome outcome = execute(task, "the simulation");
  EXPECT_TRUE(outcome.unfinished.starts_with("the frame is not finished within 10 cycles\n  pixel_scan: "));
  EXPECT_FALSE(outcome.error) << "there is nothing to measure";
  EXPECT_EQ(error_of<LimitError>([&] { require_finished(outcome); }), outcome.unfinished);
  const TaskList list{.size = 1, .what = "a run", .prepare = [&](std::size_t) { return task; }};
  EXPECT_EQ(error_of<LimitError>([&] { execute(list, 1); }), outcome.unfinished);
}

}  // namespace
}  // namespace pyrasim
