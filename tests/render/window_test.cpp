// SPDX-License-Identifier: Apache-2.0
// A part of the screen is that part of the whole picture.
#include <gtest/gtest.h>

#include "../windows.h"
#include "render/method.h"

namespace pyrasim {
namespace {

Rendering render_window(const Scene& scene, const PixelWindow& window, const Method& method = {}, int threads = 2) {
  return render(seen_through(scene, window), method, {}, threads);
}

const PixelWindow whole{0, 0, 96, 64};

/// Single pixels, single rows and columns, the corners, and sizes that leave bands of rows unfilled.
const std::vector<PixelWindow> windows{whole,          {0, 0, 1, 1},    {95, 63, 1, 1}, {0, 0, 8, 8},
                                       {88, 56, 8, 8}, {13, 7, 31, 19}, {0, 20, 96, 1}, {50, 0, 1, 64}};

void expect_parts_of_the_whole(const Method& method, const DatapathFormats& formats) {
  const Scene scene = random_scene(71, {25, 25, 1}, whole.columns, whole.rows);
  const Image full = render(scene, method, formats, 1).image;
  for (const PixelWindow& window : windows) {
    for (const int threads : {1, 2}) {
      const Image part = render(seen_through(scene, window), method, formats, threads).image;
      ASSERT_EQ(part.columns(), window.columns);
      ASSERT_EQ(part.rows(), window.rows);
      expect_same_pixels(part, window, full, whole);
    }
  }
}

TEST(Window, PyramidsArePartsOfTheWholePicture) {
  for (const Reuse reuse : {Reuse::none, Reuse::pixel, Reuse::frame}) {
    for (const char* formats : {"double", "view_vectors=fp24,intersection=float"}) {
      Method method;
      method.pyramids.reuse = reuse;
      expect_parts_of_the_whole(method, parse_datapath_formats(formats));
    }
  }
}

TEST(Window, PeersArePartsOfTheWholePicture) {
  for (const char* name : {"point", "grid:2", "grid:3", "jitter:1", "jitter:3"}) {
    SCOPED_TRACE(name);
    for (const char* formats : {"double", "view_vectors=fp24,intersection=float"}) {
      expect_parts_of_the_whole(parse_method(name), parse_datapath_formats(formats));
    }
  }
}

TEST(Window, CountsItsOwnRays) {
  const Scene scene = random_scene(71, {25, 25, 1}, whole.columns, whole.rows);
  for (const PixelWindow& window : windows) {
    const auto columns = static_cast<std::uint64_t>(window.columns);
    const auto rows = static_cast<std::uint64_t>(window.rows);
    const FrameStatistics pyramids = render_window(scene, window).statistics;
    EXPECT_EQ(pyramids.primary_rays(), (columns + 1) * (rows + 1));
    EXPECT_EQ(pyramids.subdivision_rays_traced(), 5 * pyramids.subdivisions);
    EXPECT_EQ(pyramids.terminal_nodes, columns * rows + 3 * pyramids.subdivisions);
    EXPECT_EQ(render_window(scene, window, parse_method("grid:3")).statistics.total_rays(), 9 * columns * rows);
  }
}

/// Windows side by side classify together what the whole frame does.
TEST(Window, TilesAddUpToTheWhole) {
  const Scene scene = random_scene(71, {25, 25, 1}, whole.columns, whole.rows);
  FrameStatistics tiles;
  for (const PixelWindow& tile :
       std::vector<PixelWindow>{{0, 0, 37, 21}, {37, 0, 59, 21}, {0, 21, 37, 43}, {37, 21, 59, 43}}) {
    tiles += render_window(scene, tile).statistics;
  }
  const FrameStatistics all = render_window(scene, whole).statistics;
  EXPECT_GT(all.subdivisions, 0U);
  EXPECT_EQ(tiles.cases_by_level, all.cases_by_level);
  EXPECT_EQ(tiles.subdivisions, all.subdivisions);
  EXPECT_EQ(tiles.terminal_nodes, all.terminal_nodes);
}

TEST(Window, OfALargeScreenAgreesWithThoseThatOverlapIt) {
  const LargeScreen large;
  Method method;
  method.pyramids.max_level = 6;
  for (const PixelWindow& window : large.windows) {
    const Rendering rendering = render_window(large.scene, window, method);
    EXPECT_GT(rendering.statistics.rays_by_level[6], 0U);
    const auto inwards = [](int first, int by) { return first < 8000 ? first + by : first - by; };
    const PixelWindow overlapping{inwards(window.column, 3), inwards(window.row, 2), 8, 8};
    expect_same_pixels(rendering.image, window, render_window(large.scene, overlapping, method, 1).image, overlapping);
  }
}

/// An upright edge splits 1 + 2 + 4 + ... subpixels of its pixel; the last addresses are just below 2^32.
TEST(Window, OfTheLargestScreenAtTheDeepestLevel) {
  Scene scene = empty_scene(max_screen_size, max_screen_size, 1.0 / max_screen_size);
  scene.objects = {left_of(scene.camera.screen, max_screen_size - 1 + 1 / 3.0)};
  Method method;
  method.pyramids.max_level = max_level_limit;
  const Rendering rendering = render_window(scene, {max_screen_size - 2, max_screen_size - 1, 2, 1}, method);
  EXPECT_EQ(rendering.statistics.subdivisions, (1U << max_level_limit) - 1);
  EXPECT_EQ(rendering.image.at(0, 0), glm::vec3(1));
  EXPECT_NEAR(rendering.image.at(0, 1).x, 0.125 + 0.875 / 3, 1e-5);
}

}  // namespace
}  // namespace pyrasim
