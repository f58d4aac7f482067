// SPDX-License-Identifier: Apache-2.0
// The reference renderer against closed forms.
#include "render/pyramid_renderer.h"

#include <gtest/gtest.h>

#include <atomic>
#include <glm/vec2.hpp>
#include <new>

#include "../test_scenes.h"
#include "image/image_error.h"

namespace pyrasim {
namespace {

Rendering render(const Scene& scene, const PyramidOptions& options) {
  return render_pyramids(scene, SceneIntersector<double>(scene), options);
}

/// Rays and terminal nodes as the numbers of pixels and subdivisions demand, under reuse none.
void expect_closed_forms(const Scene& scene, const FrameStatistics& statistics) {
  const Screen& screen = scene.camera.screen;
  const auto rows = static_cast<std::uint64_t>(screen.rows);
  const auto columns = static_cast<std::uint64_t>(screen.columns);
  EXPECT_EQ(statistics.primary_rays(), (rows + 1) * (columns + 1));
  EXPECT_EQ(statistics.total_rays(), (rows + 1) * (columns + 1) + 5 * statistics.subdivisions);
  EXPECT_EQ(statistics.terminal_nodes, rows * columns + 3 * statistics.subdivisions);
  std::uint64_t split = 0;
  for (std::size_t level = 0; level < statistics.cases_by_level.size(); ++level) {
    std::uint64_t pyramids = 0;
    for (const std::uint64_t count : statistics.cases_by_level[level]) pyramids += count;
    EXPECT_EQ(pyramids, level == 0 ? rows * columns : 4 * split) << level;
    const std::uint64_t next = level + 1 < statistics.rays_by_level.size() ? statistics.rays_by_level[level + 1] : 0;
    EXPECT_EQ(next % 5, 0U);
    split = next / 5;
    EXPECT_TRUE(split == 0 || split == statistics.cases_by_level[level][static_cast<std::size_t>(PyramidCase::edge)]);
  }
}

/// A triangle so large that on the screen it is all that lies to the side of the line from `a` to `b` on which `inner`
/// lies; points are rows and columns in pixels.
Object half_plane(const Screen& screen, glm::dvec2 a, glm::dvec2 b, glm::dvec2 inner) {
  const auto far = [](glm::dvec2 from, glm::dvec2 to) { return from + (to - from) * 1000.0; };
  const auto on_screen = [&](glm::dvec2 point) {
    return glm::dvec3(1, (screen.rows / 2.0 - point.x) * screen.dy, (point.y - screen.columns / 2.0) * screen.dz);
  };
  const glm::dvec2 middle = (a + b) * 0.5;
  return object(Triangle{{on_screen(far(middle, a)), on_screen(far(middle, b)), on_screen(far(middle, inner))}});
}

TEST(PyramidRenderer, EmptyScene) {
  const Scene scene = empty_scene(640, 480, 0.0025);
  const Rendering rendering = render(scene, {});
  EXPECT_EQ(rendering.statistics.total_rays(), 308'321U);
  EXPECT_EQ(rendering.statistics.subdivisions, 0U);
  EXPECT_EQ(rendering.statistics.terminal_nodes, 307'200U);
  EXPECT_EQ(rendering.statistics.work, Work{});
  for (const glm::vec3& pixel : rendering.image.pixels()) ASSERT_EQ(pixel, glm::vec3(scene.background));
}

TEST(PyramidRenderer, CoveredScreenIsOneColor) {
  Scene scene = empty_scene(33, 21, 0.01);
  scene.objects = {object(Plane{{1, 0, 0}, 3}, {0.25, 0.75, 1})};
  const Rendering rendering = render(scene, {});
  EXPECT_EQ(rendering.statistics.subdivisions, 0U);
  for (const glm::vec3& pixel : rendering.image.pixels()) ASSERT_EQ(pixel, glm::vec3(0.25, 0.75, 1));
}

/// An edge through k pixels costs 5 k rays at level 1.
TEST(PyramidRenderer, UprightEdgeCrossesOnePixelARow) {
  Scene scene = empty_scene(16, 12, 0.0625);
  scene.objects = {half_plane(scene.camera.screen, {0, 5.3}, {12, 5.3}, {6, 0})};
  const Rendering rendering = render(scene, {.max_level = 1});
  EXPECT_EQ(rendering.statistics.subdivisions, 12U);
  EXPECT_EQ(rendering.statistics.total_rays(), 17U * 13 + 5 * 12);
  // Column 5: the left half's corners are 5 (inside) and 5.5 (outside); half of it half covered.
  const glm::dvec3 mixed = scene.background * 0.75 + scene.objects[0].color * 0.25;
  for (int row = 0; row < 12; ++row) {
    EXPECT_EQ(rendering.image.at(row, 4), glm::vec3(1));
    EXPECT_EQ(rendering.image.at(row, 5), glm::vec3(mixed));
    EXPECT_EQ(rendering.image.at(row, 6), glm::vec3(scene.background));
  }
}

/// From row 4.3 at column 0 to row 12.3 at column 16: 1 pixel, and one more for each of the 15 grid lines between
/// columns and the 8 between rows that it crosses.
TEST(PyramidRenderer, SlantedEdgeCrossesTwentyFourPixels) {
  Scene scene = empty_scene(16, 16, 0.0625);
  scene.objects = {half_plane(scene.camera.screen, {4.3, 0}, {12.3, 16}, {16, 0})};
  const Rendering rendering = render(scene, {.max_level = 1});
  EXPECT_EQ(rendering.statistics.subdivisions, 24U);
  EXPECT_EQ(rendering.statistics.subdivision_rays_traced(), 5U * 24);
}

/// An upright edge splits at every level the two subpixels that it runs through: 1 + 2 + 4 + ... a row.
TEST(PyramidRenderer, UprightEdgeDoublesItsSubpixelsWithEveryLevel) {
  Scene scene = empty_scene(8, 6, 0.125);
  scene.objects = {half_plane(scene.camera.screen, {0, 3 + 1 / 3.0}, {6, 3 + 1 / 3.0}, {3, 0})};
  for (int max_level = 0; max_level <= 10; ++max_level) {
    const Rendering rendering = render(scene, {.max_level = max_level});
    EXPECT_EQ(rendering.statistics.subdivisions, 6U * ((1U << max_level) - 1));
    expect_closed_forms(scene, rendering.statistics);
    // Coverage 1/3 of the pixel, off by at most half a subpixel under edge=mean.
    const double red = 0.125 + 0.875 / 3;
    EXPECT_NEAR(rendering.image.at(2, 3).x, red, 0.875 * std::ldexp(0.5, -max_level) + 1e-7) << max_level;
  }
}

/// A fin that runs between the corner rays of one column hits none of them.
TEST(PyramidRenderer, ThinFinBetweenCornersIsNotSeen) {
  Scene scene = empty_scene(8, 8, 0.125);
  const double z = -0.5 + 0.125 * 3.5;  // the middle of column 3
  scene.objects = {object(Triangle{{{{1, 9, z - 0.03}, {1, 9, z + 0.03}, {1, -9, z}}}})};
  const Rendering rendering = render(scene, {.max_level = 5});
  EXPECT_EQ(rendering.statistics.subdivisions, 0U);  // case 4, decision D9
}

TEST(PyramidRenderer, ImagesAndCountsDoNotDependOnThreads) {
  const Scene scene = random_scene(21, {30, 30, 1}, 61, 43);
  for (const Reuse reuse : {Reuse::none, Reuse::pixel, Reuse::frame}) {
    const Rendering one = render(scene, {.max_level = 4, .reuse = reuse, .threads = 1});
    for (const int threads : {2, 3, 7}) {
      const Rendering many = render(scene, {.max_level = 4, .reuse = reuse, .threads = threads});
      EXPECT_TRUE(many.image.pixels() == one.image.pixels());
      EXPECT_EQ(many.statistics.rays_by_level, one.statistics.rays_by_level);
      EXPECT_EQ(many.statistics.cases_by_level, one.statistics.cases_by_level);
      EXPECT_EQ(many.statistics.repeated_in_pixel, one.statistics.repeated_in_pixel);
      EXPECT_EQ(many.statistics.repeated_between_pixels, one.statistics.repeated_between_pixels);
      EXPECT_EQ(many.statistics.work, one.statistics.work);
    }
  }
}

/// The same view at any size, also where rows do not fill the last band of rows that a thread takes.
TEST(PyramidRenderer, ClosedFormsAtOddSizes) {
  struct Size {
    int columns, rows;
  };
  for (const auto& [columns, rows] :
       std::vector<Size>{{1, 1}, {1, 7}, {9, 1}, {20'000, 1}, {1, 3000}, {7, 8}, {7, 9}, {7, 15}, {7, 16}, {7, 17}}) {
    const Scene scene = random_scene(22, {20, 20, 0}, columns, rows);
    const Rendering one = render(scene, {.max_level = 2, .threads = 1});
    expect_closed_forms(scene, one.statistics);
    const Rendering three = render(scene, {.max_level = 2, .reuse = Reuse::frame, .threads = 3});
    EXPECT_TRUE(one.image.pixels() == three.image.pixels()) << columns << "x" << rows;
  }
}

TEST(PyramidRenderer, ClosedFormsAtEveryMaxLevel) {
  const Scene scene = random_scene(23, {15, 15, 1}, 20, 13);
  for (int max_level = 0; max_level <= 10; ++max_level) {
    const Rendering rendering = render(scene, {.max_level = max_level});
    expect_closed_forms(scene, rendering.statistics);
    if (max_level == 0) {
      EXPECT_EQ(rendering.statistics.subdivisions, 0U);
    } else {
      EXPECT_GT(rendering.statistics.rays_by_level[static_cast<std::size_t>(max_level)], 0U);
    }
  }
}

TEST(PyramidRenderer, SinglePrecisionIsClose) {
  const Scene scene = random_scene(24, {20, 20, 0}, 40, 30);
  const Rendering wide = render(scene, {});
  const Rendering narrow = render_pyramids(scene, *make_intersector(scene, NumberFormat::single()),
                                           {.view_vectors = NumberFormat::single()});
  expect_closed_forms(scene, narrow.statistics);
  EXPECT_LT(image_error(narrow.image, wide.image).rmse, 1e-3);
}

TEST(PyramidRenderer, ProgressEndsAtOne) {
  const Scene scene = random_scene(25, {2, 2, 0}, 9, 30);
  double last = 0;
  render_pyramids(scene, SceneIntersector<double>(scene), {.threads = 2}, [&](double share) {
    EXPECT_GE(share, last);
    last = share;
    return true;
  });
  EXPECT_EQ(last, 1);
}

/// Each thread finishes the band that it has begun, and the one that needs its seam does not wait forever.
TEST(PyramidRenderer, ProgressCanStopIt) {
  const Scene scene = random_scene(26, {2, 2, 0}, 20, 200);
  for (int round = 0; round < 20; ++round) {
    int reports = 0;
    render_pyramids(scene, SceneIntersector<double>(scene), {.threads = 4}, [&](double) {
      ++reports;
      return false;
    });
    EXPECT_LE(reports, 4);
  }
}

/// Runs out of memory in the ray `rays`.
class ExhaustedTracer final : public Intersector {
 public:
  ExhaustedTracer(const Scene& scene, int rays) : scene_(scene), rays_(rays) {}
  Sample intersect(const glm::dvec3& view_vector, Work& work) const override {
    if (rays_-- == 0) throw std::bad_alloc();
    return scene_.intersect(view_vector, work);
  }
  SceneContents contents() const override { return scene_.contents(); }

 private:
  SceneIntersector<double> scene_;
  mutable std::atomic<int> rays_;
};

/// Whichever thread it is in, the error arrives, and the one that needs the seam does not wait forever.
TEST(PyramidRenderer, ErrorsOfAThreadAreThrown) {
  for (const int columns : {1, 5}) {
    const Scene scene = random_scene(26, {2, 2, 0}, columns, 8 * 12 + 1);
    const auto all = static_cast<int>(render(scene, {.max_level = 1}).statistics.total_rays());
    for (int rays = 0; rays < all; rays += all / 40) {
      const ExhaustedTracer intersector(scene, rays);
      EXPECT_THROW(render_pyramids<Intersector>(scene, intersector, {.max_level = 1, .threads = 4}, {}), std::bad_alloc)
          << rays;
    }
  }
}

}  // namespace
}  // namespace pyrasim
