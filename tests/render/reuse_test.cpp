// SPDX-License-Identifier: Apache-2.0
// Decision D3: what each policy of reuse traces, against the points that a naive renderer asks for.
#include <gtest/gtest.h>

#include "../test_scenes.h"
#include "image/image_error.h"
#include "naive_renderer.h"
#include "render/pyramid_renderer.h"

namespace pyrasim {
namespace {

Rendering render(const Scene& scene, const PyramidOptions& options) {
  return render_pyramids(scene, SceneIntersector<double>(scene), options);
}

Scene unlit_scene(std::uint64_t seed, const RandomContents& contents, int columns, int rows) {
  Scene scene = random_scene(seed, contents, columns, rows);
  scene.light.reset();
  return scene;
}

TEST(NaiveRenderer, AgreesWithTheRenderer) {
  for (std::uint64_t seed = 31; seed <= 36; ++seed) {
    const Scene scene = unlit_scene(seed, {8, 8, seed % 2 == 0 ? 1 : 0, 0, 0, 0, 3, 3}, 24, 19);
    for (const int max_level : {0, 1, 3, 5}) {
      for (const EdgePolicy edge : {EdgePolicy::mean, EdgePolicy::drop}) {
        NaiveRenderer naive(scene, max_level, edge == EdgePolicy::drop);
        naive.render();
        const Rendering rendering = render(scene, {.max_level = max_level, .edge = edge});
        EXPECT_LT(image_error(rendering.image, naive.image).maximum, 1e-6) << seed << " " << max_level;
        EXPECT_EQ(rendering.statistics.total_rays(), naive.rays);
        EXPECT_EQ(rendering.statistics.subdivisions, naive.subdivisions);
        EXPECT_EQ(rendering.statistics.terminal_nodes, naive.terminal_nodes);
      }
    }
  }
}

TEST(Reuse, EachPolicyTracesItsPointsOnce) {
  for (const int threads : {1, 3}) {
    for (std::uint64_t seed = 41; seed <= 44; ++seed) {
      const Scene scene = unlit_scene(seed, {10, 10, 0}, 21, 26);
      for (const int max_level : {1, 2, 5}) {
        NaiveRenderer naive(scene, max_level, false);
        naive.render();
        ASSERT_GT(naive.subdivisions, 0U);
        const std::uint64_t corners = 22U * 27;
        const auto rays = [&](Reuse reuse) {
          return render(scene, {.max_level = max_level, .reuse = reuse, .threads = threads}).statistics.total_rays();
        };
        EXPECT_EQ(rays(Reuse::none), corners + 5 * naive.subdivisions);
        EXPECT_EQ(rays(Reuse::pixel), corners + naive.points_by_pixel);
        EXPECT_EQ(rays(Reuse::frame), corners + naive.points.size());
      }
    }
  }
}

/// The image is the same under all policies, and each run foretells the rays of the other two.
TEST(Reuse, PoliciesAgreeOnImageAndCounts) {
  const Scene scene = random_scene(51, {25, 25, 1}, 47, 33);
  for (int max_level = 0; max_level <= 6; ++max_level) {
    const Rendering none = render(scene, {.max_level = max_level, .reuse = Reuse::none});
    const Rendering pixel = render(scene, {.max_level = max_level, .reuse = Reuse::pixel});
    const Rendering frame = render(scene, {.max_level = max_level, .reuse = Reuse::frame});
    for (const Rendering* other : {&pixel, &frame}) {
      EXPECT_TRUE(other->image.pixels() == none.image.pixels());
      EXPECT_EQ(other->statistics.cases_by_level, none.statistics.cases_by_level);
      EXPECT_EQ(other->statistics.subdivisions, none.statistics.subdivisions);
      EXPECT_EQ(other->statistics.terminal_nodes, none.statistics.terminal_nodes);
      EXPECT_EQ(other->statistics.repeated_in_pixel, none.statistics.repeated_in_pixel);
      EXPECT_EQ(other->statistics.repeated_between_pixels, none.statistics.repeated_between_pixels);
    }
    const std::uint64_t total = none.statistics.total_rays();
    EXPECT_EQ(pixel.statistics.total_rays(), total - none.statistics.repeated_in_pixel);
    EXPECT_EQ(frame.statistics.total_rays(), pixel.statistics.total_rays() - none.statistics.repeated_between_pixels);
    if (max_level < 2) {
      EXPECT_EQ(none.statistics.repeated_in_pixel, 0U);  // five points of one subdivision all differ
    }
  }
}

/// One row of pixels has no neighbours above or below, a single pixel none at all.
TEST(Reuse, ASinglePixelSharesNothingWithItsNeighbours) {
  Scene scene = empty_scene(1, 1, 1);
  scene.objects = {object(Sphere{{5, 1, 1}, 2.2})};
  const Rendering rendering = render(scene, {.max_level = 5});
  EXPECT_GT(rendering.statistics.subdivisions, 10U);
  EXPECT_GT(rendering.statistics.repeated_in_pixel, 0U);
  EXPECT_EQ(rendering.statistics.repeated_between_pixels, 0U);
}

}  // namespace
}  // namespace pyrasim
