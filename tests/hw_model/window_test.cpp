// SPDX-License-Identifier: Apache-2.0
// Machines that render a window of the screen: image, counts and time.
#include <gtest/gtest.h>

#include "../error_of.h"
#include "../windows.h"
#include "error.h"
#include "simulation.h"

namespace pyrasim::hw {
namespace {

/// Both engines, the decoupled one also with corners traced ahead; all three with the reference's results.
class Trio {
 public:
  Trio(Simulation& simulation, const Scene& scene, const MachineSpec& spec, int max_level) {
    SimulationOptions options;
    options.max_level = max_level;
    expected_ = reference(scene, options);
    machines_.push_back(&simulation.add(scene, spec, options));
    options.threads = 2;
    machines_.push_back(&simulation.add(scene, spec, options));
    options.engine = Engine::lockstep;
    machines_.push_back(&simulation.add(scene, spec, options));
  }

  void expect_agreement() const {
    for (const Processor* machine : machines_) {
      expect_results(*machine, expected_);
      expect_sound(*machine);
      expect_same_time(*machine, *machines_.front());
    }
  }
  const Rendering& rendering() const { return expected_; }
  const Image& image() const { return machines_.front()->image(); }

 private:
  Rendering expected_;
  std::vector<Processor*> machines_;
};

TEST(WindowOfAMachine, IsThatPartOfTheWholePicture) {
  const PixelWindow whole{0, 0, 96, 64};
  const std::vector<PixelWindow> windows{{0, 0, 8, 8},   {88, 56, 8, 8}, {13, 7, 31, 19},
                                         {0, 20, 96, 1}, {50, 0, 1, 64}, {95, 63, 1, 1}};
  const Scene scene = random_scene(71, {25, 25, 1}, whole.columns, whole.rows);
  Simulation simulation;
  const Trio full(simulation, scene, {}, 3);
  std::vector<Trio> parts;
  parts.reserve(windows.size());
  for (const PixelWindow& window : windows)
    parts.emplace_back(simulation, seen_through(scene, window), MachineSpec{}, 3);
  simulation.run();
  full.expect_agreement();
  for (std::size_t k = 0; k < windows.size(); ++k) {
    parts[k].expect_agreement();
    ASSERT_EQ(parts[k].image().columns(), windows[k].columns);
    expect_same_pixels(parts[k].image(), windows[k], full.image(), whole);
  }
}

TEST(WindowOfAMachine, OfALargeScreen) {
  const LargeScreen large;
  Simulation simulation;
  std::vector<Trio> parts;
  parts.reserve(large.windows.size());
  for (const PixelWindow& window : large.windows) {
    parts.emplace_back(simulation, seen_through(large.scene, window), MachineSpec{}, 6);
    EXPECT_GT(parts.back().rendering().statistics.rays_by_level[6], 0U);
  }
  simulation.run();
  for (const Trio& part : parts) part.expect_agreement();
}

/// The classifier keeps a row of the window's corners, not of the screen's.
TEST(WindowOfAMachine, NeedsARowOfItsOwnCorners) {
  const Scene scene = seen_through(random_scene(71, {5, 5, 0}, 96, 64), {20, 30, 8, 6});
  MachineSpec spec;
  spec.line_buffer = 10;
  Simulation simulation;
  const Trio machines(simulation, scene, spec, 2);
  spec.line_buffer = 9;
  EXPECT_NE(error_of<InputError>([&] { simulation.add(scene, spec, {}); }).find("line_buffer: 9"), std::string::npos);
  simulation.run();
  machines.expect_agreement();
}

/// A small sphere behind the middle corner, so that four pixels have an edge, which is short enough to be followed to
/// the finest subpixels.
TEST(DeepestLevel, OnFourByFourPixels) {
  Scene scene = empty_scene(4, 4, 0.25);
  scene.objects = {object(Sphere{{10, 0, 0}, 0.05})};
  Simulation simulation;
  const Trio machines(simulation, scene, {}, max_level_limit);
  simulation.run();
  machines.expect_agreement();
  const FrameStatistics& counts = machines.rendering().statistics;
  EXPECT_EQ(counts.cases_by_level[0][static_cast<std::size_t>(PyramidCase::edge)], 4U);
  EXPECT_GT(counts.rays_by_level[max_level_limit], 10'000U);
}

}  // namespace
}  // namespace pyrasim::hw
