// SPDX-License-Identifier: Apache-2.0
#include "hw_model/report/pixel_history.h"

#include <gtest/gtest.h>

#include <array>
#include <deque>
#include <random>
#include <set>

#include "../../test_scenes.h"
#include "../random_machine.h"
#include "../simulation.h"
#include "render/cost_maps.h"

namespace pyrasim::hw {
namespace {

/// A machine with the histories of all of its pixels.
struct Frame {
  Frame(Simulation& simulation, const Scene& scene, std::mt19937_64& random, int number)
      : maps(scene.camera.rendered(), number % 4),
        machine(simulation.add(scene, random_machine(random, number % 4), [&] {
          SimulationOptions options;
          options.max_level = number % 4;
          options.maps = &maps;
          options.engine = number % 5 == 0 ? Engine::lockstep : Engine::decoupled;
          return options;
        }())) {
    for (std::uint32_t pixel = 0; pixel < machine.image().pixels().size(); ++pixel) {
      machine.attach(histories.emplace_back(machine, pixel));
    }
  }
  CostMaps maps;
  Processor& machine;
  std::deque<PixelHistory> histories;
};

class PixelHistories : public testing::Test {
 protected:
  PixelHistories() {
    std::mt19937_64 random(71);
    for (int k = 0; k < 16; ++k) {
      Scene scene = random_scene(random(), {7, 6, 0}, 12, 10);
      if (k % 3 == 0) scene = under_lights(std::move(scene), random);
      frames_.emplace_back(simulation_, scene, random, k);
    }
    simulation_.run();
  }
  Simulation simulation_;
  std::deque<Frame> frames_;
};

/// From the scan to the frame buffer every cycle of every pixel's latency is service, latency of a unit, a wait in a
/// FIFO or in a unit.
TEST_F(PixelHistories, LeaveNoCycleOut) {
  std::array<Cycle, 4> kinds{};
  for (const Frame& frame : frames_) {
    for (const PixelHistory& history : frame.histories) {
      const std::vector<LifeStep> life = history.life();
      ASSERT_FALSE(life.empty());
      Cycle end = life.front().begin;
      for (const LifeStep& step : life) {
        EXPECT_EQ(step.begin, end);
        EXPECT_LT(step.begin, step.end);
        end = step.end;
        kinds[static_cast<std::size_t>(step.kind)] += step.end - step.begin;
      }
      EXPECT_LT(end, history.stored());
      EXPECT_STREQ(frame.machine.stages()[life.front().place]->basename(), "pixel_scan");
      EXPECT_EQ(end - life.front().begin, frame.maps.latency()[history.pixel()]);
    }
  }
  for (const Cycle cycles : kinds) EXPECT_GT(cycles, 0U);
}

/// Each ray is in the history of its own pixel, with all of its hops; a corner also in those of its neighbours.
TEST_F(PixelHistories, HoldEveryRay) {
  for (const Frame& frame : frames_) {
    std::set<std::uint64_t> rays;
    std::size_t nodes = 0;
    for (const PixelHistory& history : frame.histories) {
      for (const Hop& hop : history.hops()) {
        EXPECT_LT(hop.written, hop.visible);
        EXPECT_LE(hop.visible, hop.read);
        if (hop.subject.ray != no_number) rays.insert(hop.subject.ray);
        nodes += frame.machine.wires()[hop.fifo].fifo->basename() == std::string("pyramid_classifier_to_color_unit");
      }
    }
    EXPECT_EQ(rays.size(), frame.machine.statistics().total_rays());
    EXPECT_EQ(nodes, frame.machine.statistics().terminal_nodes);
  }
}

}  // namespace
}  // namespace pyrasim::hw
