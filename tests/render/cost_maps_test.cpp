// SPDX-License-Identifier: Apache-2.0
#include "render/cost_maps.h"

#include <gtest/gtest.h>

#include <numeric>

#include "../test_scenes.h"
#include "error.h"
#include "image/map_colors.h"
#include "render/picture_memory.h"
#include "render/pyramid_renderer.h"

namespace pyrasim {
namespace {

std::uint64_t sum(const std::vector<std::uint64_t>& values) {
  return std::accumulate(values.begin(), values.end(), std::uint64_t{0});
}

/// The corners of the first row and column belong to no pixel alone.
TEST(CostMaps, RaysAddUpToTheFrames) {
  for (const int max_level : {0, 1, 4}) {
    for (const int threads : {1, 3}) {
      Scene scene = random_scene(81, {15, 15, 1}, 37, 29);
      scene.camera.window = PixelWindow{5, 7, 21, 17};
      CostMaps maps(scene.camera.rendered(), max_level);
      const Rendering rendering = render_pyramids(scene, SceneIntersector<double>(scene),
                                                  {.max_level = max_level, .threads = threads, .maps = &maps});
      EXPECT_EQ(sum(maps.rays()) + 21 + 17 + 1, rendering.statistics.total_rays());
    }
  }
}

/// Whichever of them are traced.
TEST(CostMaps, RaysAreThoseAskedFor) {
  const Scene scene = random_scene(82, {15, 15, 0}, 20, 15);
  std::vector<std::vector<std::uint64_t>> rays;
  for (const Reuse reuse : {Reuse::none, Reuse::pixel, Reuse::frame}) {
    CostMaps maps(scene.camera.rendered(), 3);
    render_pyramids(scene, SceneIntersector<double>(scene), {.reuse = reuse, .maps = &maps});
    rays.push_back(maps.rays());
  }
  EXPECT_EQ(rays[0], rays[1]);
  EXPECT_EQ(rays[0], rays[2]);
}

/// A pixel split once, of one covered part, two empty ones and an edge.
TEST(CostMaps, ColoursSayCaseAndLevel) {
  const PixelWindow window{0, 0, 4, 1};
  CostMaps maps(window, 1);
  maps.add_terminal_node(0, PyramidCase::empty, 1);
  maps.add_terminal_node(1, PyramidCase::covered, 1);
  for (int k = 0; k < 4; ++k) maps.add_terminal_node(2, PyramidCase::covered, 0);
  for (const PyramidCase which : {PyramidCase::covered, PyramidCase::empty, PyramidCase::empty, PyramidCase::edge}) {
    maps.add_terminal_node(3, which, 0);
  }
  EXPECT_EQ(maps.rays(), (std::vector<std::uint64_t>{1, 1, 6, 6}));
  const Image picture = maps.picture(CostMap::cases);
  const glm::vec3 empty = picture.at(0, 0), covered = picture.at(0, 1), split = picture.at(0, 2),
                  mixed = picture.at(0, 3);
  EXPECT_GT(covered.z, empty.z);
  EXPECT_GT(covered.z, covered.x) << "blue";
  EXPECT_GT(split.x, split.z) << "orange";
  EXPECT_GT(mixed.x, split.x / 4) << "the edge is the lightest";
  EXPECT_EQ(maps.numbers(CostMap::rays).at(0, 3), glm::vec3(6));
}

TEST(CostMaps, HeatIsLogarithmicFromTheLeastToTheMost) {
  const Image map = heat_map({1, 10, 100, 100}, 2, 2);
  EXPECT_EQ(map.at(0, 0), heat_color(0));
  EXPECT_NEAR(map.at(0, 1).x, heat_color(0.5).x, 1e-6);
  EXPECT_EQ(map.at(1, 1), heat_color(1));
  EXPECT_EQ(heat_map({7, 7}, 2, 1).at(0, 1), heat_color(0)) << "all equal";
  EXPECT_EQ(heat_map({0, 0}, 2, 1).at(0, 1), heat_color(0));
  float last = -1;
  for (int k = 0; k <= 100; ++k) {
    const glm::vec3 color = heat_color(k / 100.0);
    const float luminance = 0.2126F * color.x + 0.7152F * color.y + 0.0722F * color.z;
    EXPECT_GT(luminance, last) << "lighter is more, also in print";
    last = luminance;
  }
}

TEST(CostMaps, MapsThatDoNotFitIntoMemoryAreRefused) {
  const PixelWindow window{0, 0, 1000, 1000};
  EXPECT_NO_THROW(check_picture_fits(window, 24'000'000));
  EXPECT_NO_THROW(check_picture_fits(window, 64'000'000, 40'000'000));
  EXPECT_THROW(check_picture_fits(window, 63'999'999, 40'000'000), LimitError);
}

}  // namespace
}  // namespace pyrasim
