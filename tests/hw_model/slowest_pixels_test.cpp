// SPDX-License-Identifier: Apache-2.0
#include "hw_model/slowest_pixels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "../test_scenes.h"
#include "simulation.h"

namespace pyrasim::hw {
namespace {

TEST(SlowestPixels, AreThoseThatSortingFinds) {
  std::mt19937_64 random(5);
  for (std::size_t size = 0; size < 60; ++size) {
    SlowestPixels slowest;
    std::vector<FinishedPixel> all;
    for (std::uint32_t k = 0; k < size; ++k) {
      all.push_back({k, static_cast<std::uint32_t>(random() % 4), 1 + random() % 20});  // many take equally long
      slowest.add(all.back());
    }
    std::stable_sort(all.begin(), all.end(),
                     [](const FinishedPixel& a, const FinishedPixel& b) { return a.latency > b.latency; });
    all.resize(std::min(size, SlowestPixels::most));
    EXPECT_TRUE(std::equal(all.begin(), all.end(), slowest.list().begin(), slowest.list().end())) << size;
  }
}

TEST(SlowestPixels, TheSlowestHasTheGreatestLatencyOfItsLevel) {
  SimulationOptions options;
  options.max_level = 3;
  Scene scene = random_scene(3, {12, 12, 0}, 20, 15);
  scene.camera.window = PixelWindow{4, 2, 10, 9};
  Simulation simulation;
  const Processor& machine = simulation.add(scene, {}, options);
  simulation.run();
  const auto list = machine.tree_accumulator().slowest().list();
  ASSERT_EQ(list.size(), SlowestPixels::most);
  EXPECT_EQ(list.front().latency, machine.tree_accumulator().latencies()[list.front().deepest].max());
  for (const FinishedPixel& pixel : list) {
    const auto [row, column] = machine.place_of(pixel.pixel);
    EXPECT_EQ((row - 2) * 10 + column - 4, static_cast<int>(pixel.pixel));
    EXPECT_TRUE(row >= 2 && row < 11 && column >= 4 && column < 14);
  }
}

}  // namespace
}  // namespace pyrasim::hw
