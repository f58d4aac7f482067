// SPDX-License-Identifier: Apache-2.0
// Lists of lights, and who stands in them: by hand, and what holds of any scene.
#include "intersect/illumination.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "../test_scenes.h"
#include "intersect/scene_intersector.h"

namespace pyrasim {
namespace {

constexpr std::uint32_t no_light = 0;

Scene scene_of(std::vector<Light> lights, std::vector<SceneSurface> surfaces) {
  Scene scene = empty_scene(1, 1, 1);
  scene.lights = std::move(lights);
  for (SceneSurface& surface : surfaces) scene.objects.push_back(object(std::move(surface)));
  return scene;
}

template <class Scalar>
class IlluminationOf : public testing::Test {
 protected:
  struct Seen {
    Sample sample;
    Work work;
  };
  static Seen look(const Scene& scene, const glm::dvec3& direction) {
    Seen seen;
    seen.sample = SceneIntersector<Scalar>(scene).intersect(direction, seen.work);
    return seen;
  }
  static void expect_light(const Scene& scene, const glm::dvec3& direction, const glm::dvec3& light,
                           std::uint32_t lights) {
    const auto [sample, work] = look(scene, direction);
    ASSERT_NE(sample.seen.object, no_object);
    const double largest = std::max({light.x, light.y, light.z});
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(sample.shading.light()[k], light[k], 1e-6 * std::max(1.0, largest)) << k;
    EXPECT_EQ(sample.seen.lights, lights);
  }
};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(IlluminationOf, Scalars);

/// A wall at x = 5. Ambient light, a lamp 3 in front of it and 4 aside: cos = 3/5 at a distance of 5, and the sun at 60
/// degrees.
TYPED_TEST(IlluminationOf, IsTheSumOfTheLights) {
  const Plane wall{{1, 0, 0}, 5};
  const AmbientLight ambient{{0.125, 0.25, 0.5}};
  const auto lamp = [](Falloff falloff) { return PointLight{{2, 4, 0}, {1, 2, 50}, falloff, false}; };
  const DirectionalLight sun{{0.5, 0, std::sqrt(0.75)}, {2, 0, 1}, false};
  this->expect_light(scene_of({ambient}, {wall}), {1, 0, 0}, {0.125, 0.25, 0.5}, no_light);
  this->expect_light(scene_of({}, {wall}), {1, 0, 0}, {0, 0, 0}, no_light);
  this->expect_light(scene_of({lamp(Falloff::none)}, {wall}), {1, 0, 0}, {0.6, 1.2, 30}, no_light);
  this->expect_light(scene_of({lamp(Falloff::linear)}, {wall}), {1, 0, 0}, {0.12, 0.24, 6}, no_light);
  this->expect_light(scene_of({lamp(Falloff::quadratic)}, {wall}), {1, 0, 0}, {0.024, 0.048, 1.2}, no_light);
  this->expect_light(scene_of({sun}, {wall}), {1, 0, 0}, {1, 0, 0.5}, no_light);
  this->expect_light(scene_of({ambient, lamp(Falloff::linear), ambient, sun}, {wall}), {1, 0, 0}, {1.37, 0.74, 7.5},
                     no_light);
}

/// What is behind the surface, seen from the viewer, brings nothing, from whichever side he sees it.
TYPED_TEST(IlluminationOf, ComesFromTheViewersSide) {
  for (const double side : {1.0, -1.0}) {
    const Plane wall{{side, 0, 0}, 5 * side};
    this->expect_light(scene_of({PointLight{{6, 0, 0}, {1, 1, 1}, Falloff::none, true}}, {wall}), {1, 0, 0}, {0, 0, 0},
                       1);
    this->expect_light(scene_of({DirectionalLight{{-1, 0, 0}, {1, 1, 1}, true}}, {wall}), {1, 0, 0}, {0, 0, 0}, 1);
    this->expect_light(scene_of({DirectionalLight{{1, 0, 0}, {1, 1, 1}, true}}, {wall}), {1, 0, 0}, {1, 1, 1}, 1);
  }
}

/// A ball between the wall and the second of three lights; the viewer looks past it.
TYPED_TEST(IlluminationOf, IsCutOffByWhatIsBetween) {
  const DirectionalLight first{{1, 0, 0}, {1, 0, 0}, true};
  const PointLight second{{1, 4, 0}, {0, 1, 0}, Falloff::none, true};
  const PointLight third{{5, 0, 3}, {0, 0, 1}, Falloff::none, true};  // in the wall's plane
  Scene scene =
      scene_of({first, AmbientLight{{0, 0, 0.5}}, second, third}, {Plane{{1, 0, 0}, 5}, Sphere{{3, 2, 0}, 0.5}});
  this->expect_light(scene, {1, 0, 0}, {1, 0, 0.5}, 0b101);
  const auto seen = this->look(scene, {1, 0, 0});
  EXPECT_EQ(seen.work.shadow.total_rays(), 2U) << "none to a light at a right angle to the normal";
  EXPECT_GT(seen.work.shadow.tests.surface_tests[index_of_kind<SphereSurface>], 0U);
  scene.objects[1].casts_shadow = false;
  this->expect_light(scene, {1, 0, 0}, {1, std::sqrt(0.5), 0.5}, 0b111);
  scene.objects[1].casts_shadow = true;
  std::get<PointLight>(scene.lights->at(2)).shadow = false;
  this->expect_light(scene, {1, 0, 0}, {1, std::sqrt(0.5), 0.5}, 0b11);
  scene.lights->at(2) = PointLight{{3.5, 1.5, 0}, {0, 1, 0}, Falloff::none, true};
  this->expect_light(scene, {1, 0, 0}, {1, std::sqrt(0.5), 0.5}, 0b111);  // the ball is behind this lamp
  scene.objects[0].casts_shadow = scene.objects[1].casts_shadow = false;
  this->expect_light(scene, {1, 0, 0}, {1, std::sqrt(0.5), 0.5}, no_light);
}

/// The light is in the place that is seen, in a surface, inside of one.
TYPED_TEST(IlluminationOf, HoldsWhereLightsTouchSurfaces) {
  const auto lamp = [](const glm::dvec3& place, Falloff falloff) {
    return PointLight{place, {1, 1, 1}, falloff, true};
  };
  const Plane wall{{1, 0, 0}, 5};
  for (const Falloff falloff : {Falloff::none, Falloff::quadratic}) {
    this->expect_light(scene_of({lamp({5, 0, 0}, falloff)}, {wall}), {1, 0, 0}, {0, 0, 0}, 1);
  }
  const Plane ceiling{{0, 1, 0}, 3};
  this->expect_light(scene_of({lamp({2, 3, 0}, Falloff::none)}, {wall, ceiling}), {1, 0, 0}, glm::dvec3(std::sqrt(0.5)),
                     1);
  this->expect_light(scene_of({lamp({2, 3, 0}, Falloff::none)}, {wall, Sphere{{2, 3, 0}, 0.5}}), {1, 0, 0}, {0, 0, 0},
                     0);
}

/// The rays of a frame from a random place, where a closed surface stands alone, under a light outside.
enum class Closed { sphere, ellipsoid, box, cylinder, cone };
SceneSurface random_closed(std::mt19937_64& random, Closed kind, const glm::dvec3& center) {
  const glm::dvec3 size = random_vector(random, glm::dvec3(0.2), glm::dvec3(2));
  const AxisSegment axis{center, center + random_vector(random, glm::dvec3(0.2), glm::dvec3(1))};
  switch (kind) {
    case Closed::sphere:
      return Sphere{center, size.x};
    case Closed::ellipsoid:
      return Ellipsoid{center, size};
    case Closed::box:
      return Box{center - size, center + size};
    case Closed::cylinder:
      return Cylinder{axis, size.x, true};
    case Closed::cone:
      return Cone{axis, size.x, size.y, true};
  }
  return Sphere{center, 1};
}
constexpr std::array every_closed{Closed::sphere, Closed::ellipsoid, Closed::box, Closed::cylinder, Closed::cone};

template <class Visit>
void for_each_body(std::uint64_t seed, int bodies, const Visit& visit) {
  std::mt19937_64 random(seed);
  for (const Closed kind : every_closed) {
    for (int k = 0; k < bodies; ++k) {
      const glm::dvec3 center = random_vector(random, {6, -4, -4}, {20, 4, 4});
      visit(random, random_closed(random, kind, center), center);
    }
  }
}

/// Nothing else is there: what faces the light is lit.
TEST(Illumination, AConvexBodyAloneIsNeverInItsOwnShadow) {
  const std::vector<std::pair<NumberFormat, int>> formats{{{}, 1200}, {NumberFormat::single(), 1200}};
  for (const auto& [format, rays] : formats) {
    SCOPED_TRACE(format.name());
    std::uint64_t hits = 0, shadow_rays = 0, dark = 0;
    for_each_body(7, 500, [&](std::mt19937_64& random, const SceneSurface& body, const glm::dvec3& center) {
      const glm::dvec3 lamp = center + glm::normalize(random_vector(random, glm::dvec3(-1), glm::dvec3(1))) * 12.0;
      const DirectionalLight sun{random_vector(random, glm::dvec3(-1), glm::dvec3(1)), {1, 1, 1}, true};
      const auto intersector =
          make_intersector(scene_of({sun, PointLight{lamp, {1, 1, 1}, Falloff::linear, true}}, {body}), format);
      Work work;
      for (int k = 0; k < rays; ++k) {
        const glm::dvec3 towards = center + random_vector(random, glm::dvec3(-2), glm::dvec3(2));
        const Sample sample = intersector->intersect(towards / towards.x, work);
        if (sample.seen.object == no_object) continue;
        ++hits;
        dark += sample.seen.lights == 0b11 ? 0 : 1;
      }
      shadow_rays += work.shadow.total_rays();
    });
    EXPECT_EQ(dark, 0U);
    EXPECT_GT(hits, static_cast<std::uint64_t>(rays) * 650);
    EXPECT_GT(shadow_rays, static_cast<std::uint64_t>(rays) * 650);
  }
}

/// A lamp shut in reaches nothing outside; nor does one outside reach what an observer sees who is shut in.
TYPED_TEST(IlluminationOf, NothingIsLitFromBehindAClosedOccluder) {
  std::uint64_t shadow_rays = 0, lit = 0;
  for_each_body(8, 60, [&](std::mt19937_64& random, const SceneSurface& body, const glm::dvec3& center) {
    const bool has_axis = std::holds_alternative<Cylinder>(body) || std::holds_alternative<Cone>(body);
    const glm::dvec3 inside = has_axis ? center + glm::dvec3(0.05) : center;
    const Scene outside = scene_of({PointLight{inside, {1, 1, 1}, Falloff::none, true}},
                                   {Plane{{0, 1, 0}, -8}, Plane{{1, 0, 0}, 25}, Sphere{{10, 9, 2}, 2}, body});
    Scene within = scene_of(
        {PointLight{{0, 12, 3}, {1, 1, 1}, Falloff::none, true}, DirectionalLight{{1, 2, 3}, {1, 1, 1}, true}}, {body});
    within.camera.position = inside;
    within.camera.look_at = inside + glm::dvec3(1, 0, 0);
    for (const Scene& scene : {outside, within}) {
      const SceneIntersector<TypeParam> intersector(scene);
      Work work;
      for (int k = 0; k < 500; ++k) {
        const Sample sample = intersector.intersect(random_vector(random, {1, -1, -1}, {1, 1, 1}), work);
        if (sample.seen.object == no_object) continue;
        lit += sample.shading.light() == glm::dvec3(0) ? 0 : 1;
      }
      shadow_rays += work.shadow.total_rays();
    }
  });
  EXPECT_EQ(lit, 0U);
  EXPECT_GT(shadow_rays, 100'000U);
}

/// The walk to the lights finds what a test of every surface finds.
TYPED_TEST(IlluminationOf, DoesNotDependOnTheHierarchy) {
  std::uint64_t shadowed = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    std::mt19937_64 random(seed);
    const Scene scene = under_lights(random_scene(seed, {40, 60, seed % 3 == 0 ? 3 : 0, 20, 20, 20}, 64, 64), random);
    const SceneIntersector<TypeParam> intersector(scene);
    const SceneIntersector<TypeParam> exhaustive(scene, Search::exhaustive);
    for (int k = 0; k < 1000; ++k) {
      const glm::dvec3 direction = random_vector(random, {1, -0.6, -0.6}, {1, 0.6, 0.6});
      Work work;
      const Sample sample = intersector.intersect(direction, work);
      ASSERT_EQ(sample, exhaustive.intersect(direction, work)) << seed;
      shadowed += sample.seen.object != no_object && sample.shading.light() != glm::dvec3(0) ? 1 : 0;
    }
  }
  EXPECT_GT(shadowed, 1000U);
}

}  // namespace
}  // namespace pyrasim
