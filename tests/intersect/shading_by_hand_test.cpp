// SPDX-License-Identifier: Apache-2.0
// Lambert's cosine law worked out by hand: ambient + (1 - ambient) max(0, -n . l), n on the side that is seen.
#include <gtest/gtest.h>

#include <array>

#include "../test_scenes.h"
#include "intersect/scene_intersector.h"
#include "render/method.h"

namespace pyrasim {
namespace {

constexpr double ambient = 0.25;
constexpr double unlit = ambient;
constexpr double lit_by(double cosine) { return ambient + (1 - ambient) * cosine; }

struct Lighting {
  glm::dvec3 direction;  ///< the way the light travels
  double shading;
};

template <class Scalar>
class ShadingByHand : public testing::Test {
 protected:
  /// What the ray along `direction`, in observer's coordinates, sees under each of the lights.
  static void expect_shading(Scene scene, const glm::dvec3& direction, const std::vector<Lighting>& lights) {
    for (const auto& [travels, shading] : lights) {
      scene.light = SingleLight{ambient, travels};
      Work work;
      const Sample sample = SceneIntersector<Scalar>(scene).intersect(direction, work);
      EXPECT_EQ(sample.seen.object, 0U);
      EXPECT_NEAR(sample.shading.factor(), shading, 1e-6) << travels.x << " " << travels.y << " " << travels.z;
    }
    scene.light.reset();
    Work work;
    EXPECT_EQ(SceneIntersector<Scalar>(scene).intersect(direction, work).shading.factor(), 1) << "without a light";
  }
};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(ShadingByHand, Scalars);

/// Of the plane 3 x + 4 y = 12, whose normal is (3, 4, 0) / 5.
constexpr glm::dvec3 a{4, 0, -3};
constexpr glm::dvec3 b{4, 0, 3};
constexpr glm::dvec3 c{0, 3, 0};
constexpr glm::dvec3 inside{3, 0.75, 0};

/// Its vertices in every order, and as a mesh: which edge comes first decides neither the normal nor the side.
std::vector<Object> the_triangle() {
  std::vector<Object> all;
  for (const auto& vertices :
       std::vector<std::array<glm::dvec3, 3>>{{a, b, c}, {b, c, a}, {c, a, b}, {a, c, b}, {c, b, a}, {b, a, c}}) {
    all.push_back(object(Triangle{vertices}));
  }
  all.push_back(object(Mesh{{{a, b, c}, {{0, 1, 2}}}}));
  all.push_back(object(Mesh{{{a, b, c}, {{2, 1, 0}}}}));
  return all;
}

/// The observer's side of the plane has the normal -(3, 4, 0) / 5.
TYPED_TEST(ShadingByHand, TriangleFromTheOrigin) {
  for (const Object& triangle : the_triangle()) {
    Scene scene = empty_scene(8, 8, 0.25);
    scene.objects = {triangle};
    const std::vector<Lighting> lights{{{1, 0, 0}, lit_by(0.6)},
                                       {{0, 1, 0}, lit_by(0.8)},
                                       {{3, 4, 0}, 1},
                                       {{30, 40, 0}, 1},
                                       {{5, 0, 12}, lit_by(0.6 * 5 / 13)},
                                       {{4, -3, 0}, unlit},
                                       {{0, 0, 1}, unlit},
                                       {{-1, 0, 0}, unlit},
                                       {{-3, -4, 0}, unlit}};
    this->expect_shading(scene, inside, lights);
    this->expect_shading(scene, inside + glm::dvec3(0.4, -0.3, 1), lights);  // elsewhere in the plane
  }
}

/// From beyond the plane its other side is seen, and lit by what comes from there. The camera is turned: light and
/// vertices are the world's.
TYPED_TEST(ShadingByHand, TriangleFromItsOtherSide) {
  for (const Object& triangle : the_triangle()) {
    Scene scene = empty_scene(8, 8, 0.25);
    scene.objects = {triangle};
    for (const glm::dvec3& up : {glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1), glm::dvec3(1, 0, -2)}) {
      scene.camera.position = {8, 6, 1};
      scene.camera.look_at = inside;
      scene.camera.up = up;
      this->expect_shading(scene, {1, 0, 0},
                           {{{-1, 0, 0}, lit_by(0.6)},
                            {{0, -1, 0}, lit_by(0.8)},
                            {{-3, -4, 0}, 1},
                            {{-5, 0, 12}, lit_by(0.6 * 5 / 13)},
                            {{0, 0, 1}, unlit},
                            {{1, 0, 0}, unlit},
                            {{3, 4, 0}, unlit}});
    }
  }
}

/// The ray (3, 4, 0) meets the sphere at (3, 4, 0), where its normal is -(3, 4, 0) / 5.
TYPED_TEST(ShadingByHand, SphereFromOutside) {
  Scene scene = empty_scene(8, 8, 0.25);
  scene.objects = {object(Sphere{{6, 8, 0}, 5})};
  this->expect_shading(scene, {3, 4, 0},
                       {{{1, 0, 0}, lit_by(0.6)},
                        {{0, 2, 0}, lit_by(0.8)},
                        {{3, 4, 0}, 1},
                        {{5, 0, 12}, lit_by(0.6 * 5 / 13)},
                        {{0, 0, 1}, unlit},
                        {{-1, 0, 0}, unlit}});
}

/// From inside, the ray (3, 4, 0) meets it at (9, 12, 0); the side that is seen has the normal -(3, 4, 0) / 5 there.
TYPED_TEST(ShadingByHand, SphereFromInside) {
  Scene scene = empty_scene(8, 8, 0.25);
  scene.objects = {object(Sphere{{-3, -4, 0}, 20})};
  this->expect_shading(scene, {3, 4, 0},
                       {{{1, 0, 0}, lit_by(0.6)},
                        {{0, 2, 0}, lit_by(0.8)},
                        {{3, 4, 0}, 1},
                        {{5, 0, 12}, lit_by(0.6 * 5 / 13)},
                        {{0, 0, 1}, unlit},
                        {{-1, 0, 0}, unlit}});
}

/// A pixel that the surface fills has its colour times its shading.
TEST(Shading, IsWhatThePictureShows) {
  Scene scene = empty_scene(1, 1, 0.01);
  scene.camera.look_at = inside;
  scene.light = SingleLight{ambient, {5, 0, 12}};
  for (const Object& triangle : the_triangle()) {
    scene.objects = {triangle};
    scene.objects[0].color = {1, 0.5, 0.125};
    const glm::vec3 pixel = render(scene, {}, {}, 1).image.pixels()[0];
    const double shading = lit_by(0.6 * 5 / 13);
    EXPECT_NEAR(pixel.x, shading, 1e-6);
    EXPECT_NEAR(pixel.y, shading / 2, 1e-6);
    EXPECT_NEAR(pixel.z, shading / 8, 1e-6);
  }
}

}  // namespace
}  // namespace pyrasim
