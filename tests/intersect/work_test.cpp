// SPDX-License-Identifier: Apache-2.0
// The work that is counted is the work that a walk takes: the hierarchy walked once more, in the plainest way.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "../test_scenes.h"
#include "intersect/rounded_scene.h"
#include "intersect/scene_intersector.h"
#include "surface/distance_range.h"
#include "surface/plane.h"
#include "surface/sphere.h"
#include "surface/triangle.h"

namespace pyrasim {
namespace {

/// A ray along (1, y, z), child by child: nothing is kept on a stack or tested at once. It counts a box for every child
/// that a visited node has, and a surface for every one in a leaf that is visited; a child is visited if its box holds
/// the ray's slopes and begins no deeper than the nearest hit so far ends.
template <class Scalar>
class PlainWalk {
 public:
  PlainWalk(const PreparedScene<Scalar>& scene, const Vector<Scalar>& direction)
      : scene_(scene), direction_(direction), inverse_length_squared_(Scalar(1) / dot(direction, direction)) {
    for (const auto& plane : surfaces_of<PlaneSurface>(scene)) {
      ++work_.surface_tests[index_of_kind<PlaneSurface>];
      const Scalar t = plane.intersect(ViewRay<Scalar>(direction));
      const double length = static_cast<double>(t) / std::sqrt(static_cast<double>(inverse_length_squared_));
      const bool holds = length * length <= plane.error.squared_length;
      meet(t, holds ? plane.error.relative : std::numeric_limits<double>::infinity(), plane);
    }
    visit(scene.root);
  }

  const Work& work() const { return work_; }
  /// Whether two hits lay too close together to be told apart by what their distances may err by.
  bool close() const { return close_; }

 private:
  void visit(std::int32_t reference) {
    if (reference < 0) {
      std::size_t run = static_cast<std::size_t>(~reference);
      test(scene_.runs.at(run));
      while (scene_.runs.at(run).more) test(scene_.runs.at(++run));
      return;
    }
    const auto& node = scene_.nodes.at(static_cast<std::size_t>(reference));
    const auto there_is = [&](std::size_t k) { return node.child[k] != 0; };  // node 0 is the root: nobody's child
    for (std::size_t k = 0; k < node_width; ++k) work_.box_tests += there_is(k) ? 1 : 0;
    for (std::size_t k = 0; k < node_width; ++k) {
      if (k > 0 && there_is(k)) {
        EXPECT_GE(node.boxes.depth[k], node.boxes.depth[k - 1]) << "the nearest comes first";
      }
      if (there_is(k) && meets(node.boxes, k)) visit(node.child[k]);
    }
  }

  bool meets(const SlopeBoxes<Scalar>& boxes, std::size_t k) const {
    return boxes.depth[k] <= static_cast<Scalar>(nearest_end_) && boxes.lower_y[k] <= direction_.y &&
           direction_.y <= boxes.upper_y[k] && boxes.lower_z[k] <= direction_.z && direction_.z <= boxes.upper_z[k];
  }

  void test(const SurfaceRun& run) {
    for_each_kind([&](auto kind) {
      if (run.kind != kind_at<kind>) return;
      for (std::uint32_t k = 0; k < run.count; ++k) {
        ++work_.surface_tests[kind];
        if constexpr (kind != index_of_kind<InstanceSurface>) {  // instanced_triangle_test.cpp counts these
          const auto& surface = std::get<kind>(scene_.kinds).surfaces.at(run.first + k);
          const ViewRay<Scalar> ray(direction_);
          const typename std::tuple_element_t<kind, SurfaceTypes<Scalar>>::Terms terms(ray);
          meet(surface.intersect(terms), run.relative_error, surface);
        }
      }
    });
  }

  template <class Surface>
  void meet(Scalar t, double relative_error, const Surface& surface) {
    if (!(t > Scalar(0))) return;
    const DistanceRange range = range_of(static_cast<double>(t), relative_error, surface);
    if (range.lowest > nearest_end_) return;
    close_ = close_ || !(range.highest < nearest_begin_);
    nearest_begin_ = range.lowest;
    nearest_end_ = std::min(nearest_end_, range.highest);
  }

  /// Where the exact hit may lie: in double what is known of the surface is enough, else the hit itself is looked at.
  template <class Surface>
  DistanceRange range_of(double t, double relative_error, const Surface& surface) const {
    if constexpr (std::is_same_v<Scalar, double>) return {t - t * relative_error, t + t * relative_error};
    return distance_range(in_double(surface), in_double(direction_), t, scene_.rounding);
  }

  const PreparedScene<Scalar>& scene_;
  Vector<Scalar> direction_;
  Scalar inverse_length_squared_;
  double nearest_begin_ = std::numeric_limits<double>::infinity();
  double nearest_end_ = std::numeric_limits<double>::infinity();
  bool close_ = false;
  Work work_;
};

template <class Scalar>
class WorkOf : public testing::Test {
 protected:
  static Work of(const Scene& scene, const Vector<Scalar>& direction) {
    Work work;
    SceneIntersector<Scalar>(scene).intersect(to_scalar<double>({direction.x, direction.y, direction.z}), work);
    return work;
  }
};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(WorkOf, Scalars);

TYPED_TEST(WorkOf, ARayIsThatOfAPlainWalk) {
  int rays = 0;
  int close = 0;
  int known = 0;
  Work all;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const int size = static_cast<int>(seed * seed);
    const int quadrics = seed > 6 ? 3 * size : 0;
    const int tori = seed > 3 && seed < 7 ? size : 0;
    const bool known_well = quadrics == 0 && tori == 0;  // an open shell or a torus may err by the way to another side
    const int planes = seed % 3 == 0 ? 2 : 0;
    const Scene scene = random_scene(seed, {size, 2 * size, planes, size, size, quadrics, tori}, 64, 64);
    const SceneIntersector<TypeParam> intersector(scene);
    std::mt19937_64 random(seed);
    for (int k = 0; k < 500; ++k, ++rays) {
      const auto direction = to_scalar<TypeParam>(random_vector(random, {1, -0.7, -0.7}, {1, 0.7, 0.7}));
      const PlainWalk<TypeParam> plain(intersector.scene(), direction);
      close += plain.close() && known_well ? 1 : 0;
      known += known_well ? 1 : 0;
      if (plain.close()) continue;  // such a ray starts again, and finds out more
      Work work;
      intersector.intersect(direction, work);
      ASSERT_EQ(work.box_tests, plain.work().box_tests) << seed << ": " << direction.y << " " << direction.z;
      ASSERT_EQ(work.surface_tests, plain.work().surface_tests) << seed << ": " << direction.y << " " << direction.z;
      all += work;
    }
  }
  EXPECT_LT(close, known / 10);
  EXPECT_GT(all.box_tests, static_cast<std::uint64_t>(rays));
  for_each_kind([&](auto kind) {
    if (kind == index_of_kind<InstanceSurface>) return;
    EXPECT_GT(all.surface_tests[kind], static_cast<std::uint64_t>(rays) / 16);
  });
}

/// What a hit in a leaf errs by at most decides how much is looked at behind it.
TYPED_TEST(WorkOf, ALeafErrsByTheMostOfItsSurfaces) {
  const Scene scene = random_scene(6, {60, 60, 0, 30, 30, 30}, 64, 64);
  const PreparedScene<double> prepared = prepare_scene(scene, format_of<TypeParam>());
  int of_several = 0;
  for (std::size_t k = 0; k < prepared.runs.size(); ++k) {
    const double noted = prepared.runs[k].relative_error;
    double most = 0;
    std::uint32_t surfaces = 0;
    for (;; ++k) {
      const SurfaceRun& run = prepared.runs.at(k);
      EXPECT_EQ(run.relative_error, noted);
      for (std::uint32_t s = run.first; s < run.first + run.count; ++s, ++surfaces) {
        const double error = with_kind(run.kind, [&](auto kind) {
          const auto& surface = std::get<kind>(prepared.kinds).surfaces.at(s);
          if constexpr (requires { surface.error; } || kind == index_of_kind<InstanceSurface>) {
            ADD_FAILURE() << "it knows its error itself";
            return 0.0;
          } else {
            return relative_error(surface, prepared.rounding);
          }
        });
        most = std::max(most, error);
      }
      if (!run.more) break;
    }
    EXPECT_EQ(noted, most);
    of_several += surfaces > 1 ? 1 : 0;
  }
  EXPECT_GT(of_several, 10);
}

/// Small spheres side by side are worth a box each: as many tests as there are children, not as there is room for.
TYPED_TEST(WorkOf, ANodeIsATestForEachOfItsChildren) {
  for (const std::uint64_t spheres : {2, 3, 4}) {
    Scene scene = empty_scene(16, 16, 0.125);
    for (std::uint64_t k = 0; k < spheres; ++k) {
      scene.objects.push_back(object(Sphere{{10, 0, -6 + 4.0 * static_cast<double>(k)}, 0.5}));
    }
    EXPECT_EQ(this->of(scene, {1, TypeParam(0.5), 0}), (Work{spheres, {0, 0, 0}}));
    EXPECT_EQ(this->of(scene, {1, 0, TypeParam(-0.6)}), (Work{spheres, {1, 0, 0}}));
  }
}

/// Four spheres about one centre stand before four further away that reach out above them.
TYPED_TEST(WorkOf, WhatLiesBehindAHitIsNotTested) {
  Scene scene = empty_scene(16, 16, 0.125);
  for (int k = 0; k < 4; ++k) {
    scene.objects.push_back(object(Sphere{{20, 2, 0}, 2 - 0.1 * k}));
    scene.objects.push_back(object(Sphere{{5, 0, 0}, 0.5 - 0.03 * k}));
  }
  EXPECT_EQ(this->of(scene, {1, TypeParam(0.05), 0}), (Work{2, {4, 0, 0}})) << "only the nearer four";
  EXPECT_EQ(this->of(scene, {1, TypeParam(0.15), 0}), (Work{2, {4, 0, 0}})) << "only the further four";
  EXPECT_EQ(this->of(scene, {1, TypeParam(0.09), TypeParam(0.09)}), (Work{2, {8, 0, 0}}))
      << "in the corner of the nearer four's box";
  EXPECT_EQ(this->of(scene, {1, TypeParam(0.5), 0}), (Work{2, {0, 0, 0}})) << "past all";
}

/// A ray that meets surfaces too close to be told apart starts again: it pays for the walk that decides, not for both.
TYPED_TEST(WorkOf, CloseHitsArePaidForOnce) {
  Scene scene = empty_scene(16, 16, 0.125);
  scene.objects = {object(Sphere{{5, 0, 0}, 1}), object(Sphere{{5, 0, 0}, 1}), object(Plane{{1, 0, 0}, 9}),
                   object(Plane{{1, 0, 0}, 9})};
  EXPECT_EQ(this->of(scene, {1, 0, 0}), (Work{0, {2, 2, 0}}));
}

/// Boxes bound slopes: a ray that does not run forward tests everything, and no box.
TYPED_TEST(WorkOf, RaysThatRunBackwardTestEverySurface) {
  const Scene scene = random_scene(4, {30, 40, 2, 7, 9, 12, 5}, 8, 8);
  for (const TypeParam x : {-1, 0}) EXPECT_EQ(this->of(scene, {x, 1, 1}), (Work{0, {30, 2, 40, 7, 9, 3, 3, 4, 2, 5}}));
}

}  // namespace
}  // namespace pyrasim
