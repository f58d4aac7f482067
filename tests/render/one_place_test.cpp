// SPDX-License-Identifier: Apache-2.0
// Pictures of two surfaces in one place: the first in the scene and not a speckle of the other; and no edges between
// them, so that the pyramids take as many rays as of the first alone.
#include <gtest/gtest.h>

#include "../test_scenes.h"
#include "render/baseline_renderer.h"
#include "render/pyramid_renderer.h"
#include "scene/scene.h"

namespace pyrasim {
namespace {

const glm::dvec3 red(1, 0, 0);
const glm::dvec3 green(0, 1, 0);

/// 96 x 96 pixels, 40 degrees.
Scene scene_of(const SceneSurface& first, const std::vector<SceneSurface>& others) {
  Scene scene = empty_scene(96, 96, 2 * std::tan(20 * 3.141592653589793 / 180) / 96);
  scene.background = {0, 0, 0};
  scene.objects = {object(first, red)};
  for (const SceneSurface& other : others) scene.objects.push_back(object(other, green));
  return scene;
}

struct Seen {
  int red = 0;
  int other = 0;
};

/// Of a picture with one ray through each pixel's centre.
Seen seen(const Scene& scene, const NumberFormat& format) {
  const auto intersector = make_intersector(scene, format);
  Seen seen;
  const Image image = render_baseline(scene, *intersector, {.threads = 1, .view_vectors = format}).image;
  for (const glm::vec3& pixel : image.pixels()) {
    seen.red += pixel == glm::vec3(red) ? 1 : 0;
    seen.other += pixel == glm::vec3(red) || pixel == glm::vec3(0) ? 0 : 1;
  }
  return seen;
}

const glm::dvec3 a(4.760000000000001, -1.5, -1.5), b(5.87, 1.5, -1.5), c(4.685, 0, 1.5);
const Triangle facing{{{{5, -1.5, -1.5}, {5, 1.5, -1.5}, {5, 0, 1.5}}}};

struct Example {
  Scene scene;
  int red;
};

std::vector<Example> examples() {
  const Triangle overlapping{{{{5, -1.7, -1.2}, {5, 1.3, -1.9}, {5, 0.3, 1.7}}}};
  const Triangle decal{{{{4, -1.3, -1}, {4, -1.3, 1}, {9, -1.3, 1}}}};
  const Triangle other_half{{{{4, -1.3, -1}, {9, -1.3, 1}, {9, -1.3, -1}}}};
  return {{scene_of(Triangle{{{a, b, c}}}, {Triangle{{{b, c, a}}}}), 2996},
          {scene_of(facing, {overlapping}), 3200},
          {scene_of(facing, {Plane{{1, 0, 0}, 5}}), 3200},
          {scene_of(Plane{{0, 1, 0}, -1.3}, {decal, other_half}), 0}};
}

TEST(OnePlace, IsThatOfTheFirst) {
  for (const auto& [scene, pixels] : examples()) {
    const bool is_triangle = pixels > 0;
    EXPECT_EQ(is_triangle ? seen(scene, {}).red : 0, pixels);
    for (const NumberFormat& format : number_formats()) {
      Scene alone = scene;
      alone.objects.resize(1);
      EXPECT_EQ(seen(scene, format).red, seen(alone, format).red) << format.name();
    }
  }
}

TEST(OnePlace, CostsNoSubdivisions) {
  const PyramidOptions options{.max_level = 3, .threads = 1};
  const auto statistics = [&](const Scene& scene) {
    return render_pyramids(scene, *make_intersector(scene, {}), options).statistics;
  };
  const auto rotated = statistics(scene_of(Triangle{{{a, b, c}}}, {Triangle{{{b, c, a}}}}));
  const auto identical = statistics(scene_of(Triangle{{{a, b, c}}}, {Triangle{{{a, b, c}}}}));
  EXPECT_EQ(rotated.total_rays(), identical.total_rays());
  EXPECT_EQ(rotated.work, identical.work);
}

}  // namespace
}  // namespace pyrasim
