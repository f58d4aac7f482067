// SPDX-License-Identifier: Apache-2.0
#include "intersect/scene_intersector.h"

#include <gtest/gtest.h>

#include <deque>
#include <limits>

#include "../numeric/ties/every_hit.h"
#include "../test_scenes.h"

namespace pyrasim {
namespace {

/// Every surface tested, no hierarchy. Shading comes from an intersector of the hit object alone, which has none
/// either.
template <class Scalar>
class BruteForce {
 public:
  explicit BruteForce(const Scene& scene) : every_hit_(make_every_hit(scene, format_of<Scalar>())) {
    for (const Object& entry : scene.objects) {
      Scene alone = scene;
      alone.objects = {entry};
      alone_.emplace_back(alone);
    }
  }

  Sample trace(const Vector<Scalar>& direction) const {
    const std::uint32_t object = object_seen(every_hit_->of(direction));
    if (object == no_object) return {};
    Work work;
    return {{object}, alone_[object].intersect(direction, work).shading};
  }

 private:
  std::unique_ptr<EveryHit> every_hit_;
  std::deque<SceneIntersector<Scalar>> alone_;
};

template <class Scalar>
class SceneIntersectorOf : public testing::Test {
 protected:
  static void expect_equal(const SceneIntersector<Scalar>& intersector, const BruteForce<Scalar>& brute,
                           const Vector<Scalar>& direction) {
    Work work;
    const Sample sample = intersector.intersect(direction, work);
    const Sample expected = brute.trace(direction);
    ASSERT_EQ(sample.seen.object, expected.seen.object) << direction.x << " " << direction.y << " " << direction.z;
    ASSERT_EQ(sample.shading, expected.shading);
  }
  static Sample look(const Scene& scene, const Vector<Scalar>& direction) {
    Work work;
    return SceneIntersector<Scalar>(scene).intersect(direction, work);
  }
};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(SceneIntersectorOf, Scalars);

TYPED_TEST(SceneIntersectorOf, AgreesWithBruteForceOnRandomScenes) {
  int hits = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const Scene scene =
        random_scene(seed, {40, 60, seed % 3 == 0 ? 3 : 0, 20, 20, 20, 4, seed % 2 == 0 ? 20 : 0}, 64, 64);
    const SceneIntersector<TypeParam> intersector(scene);
    const BruteForce<TypeParam> brute(scene);
    std::mt19937_64 random(seed);
    for (int k = 0; k < 1500; ++k) {
      const auto direction = to_scalar<TypeParam>(random_vector(random, {1, -0.6, -0.6}, {1, 0.6, 0.6}));
      this->expect_equal(intersector, brute, direction);
      hits += brute.trace(direction).seen.object == no_object ? 0 : 1;
    }
  }
  EXPECT_GT(hits, 4000);
  EXPECT_LT(hits, 17000);
}

TYPED_TEST(SceneIntersectorOf, AgreesInEveryDirectionFromInsideTheScene) {
  Scene scene = empty_scene(1, 1, 1);
  std::mt19937_64 random(5);
  for (int k = 0; k < 200; ++k) {
    scene.objects.push_back(object(Sphere{random_vector(random, glm::dvec3(-5), glm::dvec3(5)), 0.6}));
  }
  const SceneIntersector<TypeParam> intersector(scene);
  const BruteForce<TypeParam> brute(scene);
  for (int k = 0; k < 3000; ++k) {
    this->expect_equal(intersector, brute, to_scalar<TypeParam>(random_vector(random, glm::dvec3(-1), glm::dvec3(1))));
  }
}

/// Rays along axes and within coordinate planes run inside the faces of boxes whose corners lie on whole numbers.
TYPED_TEST(SceneIntersectorOf, ZeroComponentsInBoxFaces) {
  Scene scene = empty_scene(1, 1, 1);
  for (int x = -3; x <= 3; ++x) {
    for (int y = -3; y <= 3; ++y) {
      for (int z = -3; z <= 3; ++z) {
        if (x == 0 && y == 0 && z == 0) continue;
        const glm::dvec3 corner(x, y, z);
        scene.objects.push_back(object(Triangle{{corner, corner + glm::dvec3(0, 1, 0), corner + glm::dvec3(0, 0, 1)}}));
        scene.objects.push_back(object(Triangle{{corner, corner + glm::dvec3(1, 0, 0), corner + glm::dvec3(0, 0, 1)}}));
        if ((x + y + z) % 3 == 0) scene.objects.push_back(object(Sphere{corner, 0.5}));
      }
    }
  }
  const SceneIntersector<TypeParam> intersector(scene);
  const BruteForce<TypeParam> brute(scene);
  for (int x = -4; x <= 4; ++x) {
    for (int y = -4; y <= 4; ++y) {
      for (int z = -4; z <= 4; ++z) {
        if (x == 0 && y == 0 && z == 0) continue;
        const auto direction = to_scalar<TypeParam>(glm::dvec3(x, y, z) / 4.0);
        this->expect_equal(intersector, brute, direction);
        const auto negative_zero = [](TypeParam c) { return c == 0 ? -c : c; };
        this->expect_equal(intersector, brute,
                           {negative_zero(direction.x), negative_zero(direction.y), negative_zero(direction.z)});
      }
    }
  }
}

/// Decision D7: equal distances go to the object that comes first in the scene, whatever its kind.
TYPED_TEST(SceneIntersectorOf, CoincidentSurfacesGoToTheFirst) {
  const Object sphere = object(Sphere{{3, 0, 0}, 1});  // meets the ray along x at t = 2, as the others do
  const Object plane = object(Plane{{1, 0, 0}, 2});
  const Object triangle = object(Triangle{{{{2, -1, -1}, {2, 1, -1}, {2, 0, 1}}}});
  const Object far = object(Sphere{{30, 0, 0}, 4});
  const std::vector<std::vector<Object>> orders{{sphere, plane, triangle},         {plane, sphere, triangle},
                                                {triangle, plane, sphere},         {triangle, sphere, plane},
                                                {sphere, sphere, far, far},        {triangle, far, triangle, triangle},
                                                {plane, plane, triangle, triangle}};
  for (const auto& order : orders) {
    Scene scene = empty_scene(1, 1, 1);
    scene.objects = order;
    EXPECT_EQ(this->look(scene, {1, 0, 0}).seen.object, 0U);
    scene.objects.insert(scene.objects.begin(), far);
    EXPECT_EQ(this->look(scene, {1, 0, 0}).seen.object, 1U);
  }
}

TYPED_TEST(SceneIntersectorOf, TenThousandCoincidentSpheres) {
  Scene scene = empty_scene(1, 1, 1);
  scene.objects.assign(10'000, object(Sphere{{5, 1, 0}, 2}));
  scene.objects[0].surface = Sphere{{50, 1, 0}, 2};
  const SceneIntersector<TypeParam> intersector(scene);
  Work work;
  EXPECT_EQ(intersector.intersect({1, 0.2, 0}, work).seen.object, 1U);
  EXPECT_GE(work.surface_tests[index_of_kind<SphereSurface>], 9999U);
  EXPECT_EQ(intersector.intersect({1, -0.9, 0}, work).seen.object, no_object);
}

TYPED_TEST(SceneIntersectorOf, MeshIsOneObject) {
  Scene scene = empty_scene(1, 1, 1);
  scene.objects.push_back(object(Sphere{{50, 0, 0}, 1}));
  scene.objects.push_back(object(Mesh{{{{2, -1, -1}, {2, 1, -1}, {2, 1, 1}, {2, -1, 1}}, {{{0, 1, 2}}, {{0, 2, 3}}}}}));
  for (const double y : {-0.25, 0.0, 0.25}) {
    for (const double z : {-0.25, 0.0, 0.25}) {
      EXPECT_EQ(this->look(scene, to_scalar<TypeParam>({1, y, z})).seen.object, 1U) << y << " " << z;
    }
  }
}

TYPED_TEST(SceneIntersectorOf, LambertShadingByHand) {
  Scene scene = empty_scene(1, 1, 1);
  scene.light = SingleLight{0.25, {2, 0, 0}};  // from behind the observer
  scene.objects = {object(Sphere{{5, 0, 0}, 1})};
  EXPECT_NEAR(this->look(scene, {1, 0, 0}).shading.factor(), 1, 1e-6);
  EXPECT_NEAR(this->look(scene, {4.2, 0, 0.6}).shading.factor(), 0.25 + 0.75 * 0.8, 1e-6);
  scene.light->direction = {-1, 0, 0};  // from the far side
  EXPECT_NEAR(this->look(scene, {1, 0, 0}).shading.factor(), 0.25, 1e-6);
  scene.objects = {object(Plane{{0, 1, 0}, -1})};
  scene.light->direction = {0, -3, -4};
  EXPECT_NEAR(this->look(scene, {1, -1, 0}).shading.factor(), 0.25 + 0.75 * 0.6, 1e-6);
  scene.objects = {object(Plane{{0, -2, 0}, 2})};  // the same plane, its normal away from the observer
  EXPECT_NEAR(this->look(scene, {1, -1, 0}).shading.factor(), 0.25 + 0.75 * 0.6, 1e-6);
  scene.light.reset();
  EXPECT_EQ(this->look(scene, {1, -1, 0}).shading.factor(), 1);
}

TYPED_TEST(SceneIntersectorOf, WorkWithoutAHierarchy) {
  Scene scene = empty_scene(1, 1, 1);
  Work work;
  SceneIntersector<TypeParam>(scene).intersect({1, 0, 0}, work);
  EXPECT_EQ(work, Work{});
  scene.objects.assign(3, object(Plane{{1, 0, 0}, 7}));
  scene.objects.push_back(object(Sphere{{5, 0, 0}, 1}));
  const SceneIntersector<TypeParam> intersector(scene);
  for (const TypeParam y : {0, 9}) intersector.intersect({1, y, 0}, work);
  EXPECT_EQ(work.box_tests, 0U);
  EXPECT_EQ(work.surface_tests, (std::array<std::uint64_t, surface_kinds>{2, 6, 0}));
}

TYPED_TEST(SceneIntersectorOf, WorkWithAHierarchyIsBoundedBySceneSize) {
  const Scene scene = random_scene(3, {300, 300, 2}, 8, 8);
  const SceneIntersector<TypeParam> intersector(scene);
  ASSERT_GT(intersector.scene().nodes.size(), 0U);
  std::mt19937_64 random(4);
  Work total;
  for (int k = 0; k < 1000; ++k) {
    Work work;
    intersector.intersect(to_scalar<TypeParam>(random_vector(random, {1, -0.6, -0.6}, {1, 0.6, 0.6})), work);
    EXPECT_GE(work.box_tests, 2U);
    EXPECT_LE(work.box_tests, node_width * intersector.scene().nodes.size());
    EXPECT_LE(work.surface_tests[0], 300U);
    EXPECT_EQ(work.surface_tests[1], 2U);
    EXPECT_LE(work.surface_tests[2], 300U);
    total += work;
  }
  EXPECT_LT(total.surface_tests[0] + total.surface_tests[2], 1000U * 100);  // far from all 600 for every ray
}

}  // namespace
}  // namespace pyrasim
