// SPDX-License-Identifier: Apache-2.0
#include "render/baseline_renderer.h"

#include <gtest/gtest.h>

#include "../shipped_scene.h"
#include "../test_scenes.h"
#include "image/image_error.h"

namespace pyrasim {
namespace {

Rendering samples(const Scene& scene, const BaselineOptions& options) {
  return render_baseline(scene, SceneIntersector<double>(scene), options);
}

TEST(SamplingRenderer, ConstantPicturesAreExact) {
  Scene scene = empty_scene(13, 9, 0.05);
  for (const int grid : {1, 2, 3, 7, 16}) {
    const Rendering empty = samples(scene, {.grid = grid});
    for (const glm::vec3& pixel : empty.image.pixels()) ASSERT_EQ(pixel, glm::vec3(scene.background)) << grid;
    EXPECT_EQ(empty.statistics.total_rays(), 13U * 9 * static_cast<unsigned>(grid * grid));
  }
  scene.objects = {object(Plane{{1, 0, 0}, 3}, {0.1, 0.7, 1.0 / 3})};
  for (const bool jitter : {false, true}) {
    const Rendering covered = samples(scene, {.grid = 4, .jitter = jitter});
    for (const glm::vec3& pixel : covered.image.pixels()) ASSERT_EQ(pixel, glm::vec3(0.1, 0.7, 1.0 / 3));
  }
}

/// The edge runs at 5.3 pixels from the left; of a grid's columns in pixel 5, those whose centres lie before it count.
TEST(SamplingRenderer, GridThroughCellCentresByHand) {
  Scene scene = empty_scene(16, 4, 0.0625);
  scene.background = {0, 0, 0};
  const double z = (5.3 - 8) * 0.0625;
  scene.objects = {object(Triangle{{{{1, -900, z}, {1, 900, z}, {1, 0, -900}}}})};
  const auto covered = [&](int grid) { return samples(scene, {.grid = grid}).image.at(2, 5).x; };
  EXPECT_EQ(covered(1), 0);      // centre at 0.5
  EXPECT_EQ(covered(2), 0.5F);   // 0.25 | 0.75
  EXPECT_EQ(covered(4), 0.25F);  // 0.125 | 0.375 0.625 0.875
  EXPECT_EQ(covered(8), 0.25F);  // 0.0625 0.1875 | 0.3125 ...
  EXPECT_EQ(covered(10), 0.3F);
}

TEST(SamplingRenderer, JitterFollowsItsSeedAlone) {
  const Scene scene = random_scene(61, {20, 20, 0}, 40, 30);
  const Rendering first = samples(scene, {.grid = 3, .jitter = true, .seed = 7, .threads = 1});
  for (const int threads : {1, 2, 5}) {
    const Rendering again = samples(scene, {.grid = 3, .jitter = true, .seed = 7, .threads = threads});
    EXPECT_TRUE(again.image.pixels() == first.image.pixels());
    EXPECT_EQ(again.statistics.work, first.statistics.work);
  }
  EXPECT_FALSE(samples(scene, {.grid = 3, .jitter = true, .seed = 8}).image.pixels() == first.image.pixels());
  EXPECT_FALSE(samples(scene, {.grid = 3}).image.pixels() == first.image.pixels());
}

TEST(SamplingRenderer, PeersConvergeToOnePicture) {
  const Scene scene = random_scene(62, {20, 20, 0}, 32, 24);
  const Rendering truth = samples(scene, {.grid = 64});
  double last = 1;
  for (const int grid : {1, 4, 16}) {
    const double error = image_error(samples(scene, {.grid = grid}).image, truth.image).rmse;
    const double jittered = image_error(samples(scene, {.grid = grid, .jitter = true}).image, truth.image).rmse;
    EXPECT_LT(error, last / 2) << grid;
    EXPECT_LT(jittered, last) << grid;
    last = error;
  }
}

/// What the method is for: each level brings the picture nearer to the truth, and mean leaves beat dropped ones.
TEST(PyramidError, FallsWithMaxLevelOnKeel) {
  Scene scene = shipped_scene("keel");
  scene.camera.screen = resized(scene.camera.screen, 128, 96);
  const SceneIntersector<double> intersector(scene);
  const Image truth = render_baseline(scene, intersector, {.grid = 32}).image;
  const double point = image_error(render_baseline(scene, intersector, {}).image, truth).rmse;
  double last_mean = point;
  double last_drop = 1;
  for (int max_level = 0; max_level <= 4; ++max_level) {
    const auto error = [&](EdgePolicy edge) {
      return image_error(render_pyramids(scene, intersector, {.max_level = max_level, .edge = edge}).image, truth).rmse;
    };
    const double mean = error(EdgePolicy::mean);
    const double drop = error(EdgePolicy::drop);
    EXPECT_LT(mean, last_mean) << max_level;
    EXPECT_LT(drop, last_drop) << max_level;
    EXPECT_LT(mean, drop) << max_level;
    last_mean = mean;
    last_drop = drop;
  }
  EXPECT_LT(last_mean, point / 4);
}

}  // namespace
}  // namespace pyrasim
