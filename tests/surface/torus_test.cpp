// SPDX-License-Identifier: Apache-2.0
// Tori, worked out by hand, and what a test of one costs.
#include "surface/torus.h"

#include <gtest/gtest.h>

#include "../numeric/extremes/formats.h"
#include "counted.h"
#include "surface/convert.h"

namespace pyrasim {
namespace {

TorusSurface<double> seen(const Torus& torus, const glm::dvec3& from = {0, 0, 0}) {
  Camera camera;
  camera.position = from;
  camera.look_at = from + glm::dvec3(1, 0, 0);
  return torus.prepared({ObserverFrame(camera), {}}).surface;
}

double hit(const Torus& torus, const glm::dvec3& direction, const glm::dvec3& from = {0, 0, 0}) {
  return seen(torus, from).intersect(ViewRay<double>(direction));
}

glm::dvec3 normal(const Torus& torus, const glm::dvec3& direction, const glm::dvec3& from = {0, 0, 0}) {
  const auto surface = seen(torus, from);
  return normalized(surface.outward({}, direction, surface.intersect(ViewRay<double>(direction))));
}

const Torus lying{{8, 0, 0}, {0, 3, 0}, 2, 0.5};
const Torus facing{{8, 0, 0}, {-1, 0, 0}, 2, 0.5};
const Torus horn{{8, 0, 0}, {0, 1, 0}, 1, 1};

TEST(TorusSurface, FromOutside) {
  EXPECT_DOUBLE_EQ(hit(lying, {1, 0, 0}), 5.5);
  EXPECT_EQ(hit(lying, {-1, 0, 0}), 0);
  EXPECT_EQ(hit(lying, {1, 0, 0}, {0, 0.6, 0}), 0);
  EXPECT_EQ(hit(facing, {1, 0, 0}), 0);  // through the hole
  EXPECT_DOUBLE_EQ(hit(facing, {1, 0, 0}, {0, 2, 0}), 7.5);
  EXPECT_DOUBLE_EQ(hit(facing, {1, 0, 0}, {0, 0, -2}), 7.5);
  EXPECT_EQ(hit(facing, {1, 0, 0}, {0, 0, -2.6}), 0);  // past the rim
}

TEST(TorusSurface, FromItsHoleAndFromBehind) {
  EXPECT_DOUBLE_EQ(hit(lying, {1, 0, 0}, {8, 0, 0}), 1.5);
  EXPECT_EQ(hit(lying, {0, 1, 0}, {8, 0, 0}), 0);
  EXPECT_DOUBLE_EQ(hit(lying, {1, 0, 0}, {7, 0, 0}), 2.5);
  EXPECT_EQ(hit(lying, {1, 0, 0}, {11, 0, 0}), 0);
}

TEST(TorusSurface, FromWithinTheTube) {
  EXPECT_DOUBLE_EQ(hit(lying, {1, 0, 0}, {6, 0, 0}), 0.5);
  EXPECT_DOUBLE_EQ(hit(lying, {-1, 0, 0}, {6, 0, 0}), 0.5);
  EXPECT_DOUBLE_EQ(hit(lying, {0, 1, 0}, {6, 0, 0}), 0.5);
  EXPECT_DOUBLE_EQ(hit(lying, {1, 0, 0}, {10, 0, 0}), 0.5);
  EXPECT_DOUBLE_EQ(hit(lying, {0, 0, 1}, {6, 0, 0}), 1.5);  // along the tube: to its outer side
  const glm::dvec3 tangent = {0, 0, 1};
  EXPECT_DOUBLE_EQ(hit(lying, tangent, {6.5 - 0x1p-20, 0, 0}), std::sqrt(6.25 - std::pow(1.5 + 0x1p-20, 2)));
}

/// The place that the observer stands on does not count.
TEST(TorusSurface, FromItsSkin) {
  EXPECT_DOUBLE_EQ(hit(lying, {1, 0, 0}, {5.5, 0, 0}), 1);
  EXPECT_EQ(hit(lying, {-1, 0, 0}, {5.5, 0, 0}), 0);
  EXPECT_DOUBLE_EQ(hit(lying, {1, 0, 0}, {6.5, 0, 0}), 3);  // across the hole
  EXPECT_EQ(hit(lying, {0, 1, 0}, {6, 0.5, 0}), 0);
  EXPECT_DOUBLE_EQ(hit(lying, {0, -1, 0}, {6, 0.5, 0}), 1);
}

TEST(TorusSurface, ClosedInTheMiddle) {
  EXPECT_DOUBLE_EQ(hit(horn, {1, 0, 0}), 6);
  EXPECT_NEAR(hit(horn, {0, -1, 0}, {8, 3, 0}), 3, 1e-7);  // its only place on the axis
  EXPECT_DOUBLE_EQ(hit(horn, {0, -1, 0}, {7, 3, 0}), 2);   // the top
  EXPECT_NEAR(hit(horn, {1, 0, 0}, {0, 1, 0}), 7, 1e-7);   // touching it
  EXPECT_NEAR(hit(horn, {1, 0, 0}, {8.5, 0, 0}), 1.5, 1e-12);
}

TEST(TorusSurface, Normals) {
  EXPECT_EQ(normal(lying, {1, 0, 0}), glm::dvec3(-1, 0, 0));
  EXPECT_EQ(normal(lying, {1, 0, 0}, {8, 0, 0}), glm::dvec3(-1, 0, 0));  // outward of the tube
  EXPECT_EQ(normal(lying, {0, -1, 0}, {6, 3, 0}), glm::dvec3(0, 1, 0));
}

/// A ray along the axis, and one that meets it.
TEST(TorusSurface, AxesAndRaysThatMeetThem) {
  EXPECT_EQ(hit(facing, {1, 0, 0}), 0);
  EXPECT_DOUBLE_EQ(hit({{8, 0, 0}, {0, 1, 0}, 2, 0.5}, {1, 0, 0}, {8, 0, 0}), 1.5);
  EXPECT_EQ(hit({{8, 0, 0}, {-1, 0.25, 0}, 2, 0.5}, {1, -0.25, 0}, {0, 2, 0}), 0);
}

/// The mean over rays at the torus' bounds as they are seen, of tubes thin and thick: six multiplications a cycle.
TEST(TorusSurface, DefaultCostIsThatOfItsMultiplications) {
  Random random(3);
  constexpr int rays = 20000;
  std::array<long, 3> counts{};
  for (int k = 0; k < rays; ++k) {
    const Torus torus{glm::dvec3(8, 0, 0) + random.vector(-2, 2), random.unit_vector(), 1,
                      std::exp2(random.uniform(-4, 0))};
    const TorusSurface<double> exact = seen(torus);
    const BoundingBox box = *slope_bounds(exact, 0);
    const glm::dvec3 slopes(1, random.uniform(box.lower.y, box.upper.y), random.uniform(box.lower.z, box.upper.z));
    const ViewRay<Counted> ray(to_scalar<Counted>(slopes));
    const std::array<long, 3> before{Counted::multiplications, Counted::divisions, Counted::roots};
    rounded<Counted>(exact).intersect(ray);
    counts[0] += Counted::multiplications - before[0];
    counts[1] += Counted::divisions - before[1];
    counts[2] += Counted::roots - before[2];
  }
  const auto mean = [&](std::size_t of) { return static_cast<double>(counts[of]) / rays; };
  fmt::print("[  figure  ] a test of a torus: {:.1f} multiplications, {:.1f} divisions, {:.1f} roots\n", mean(0),
             mean(1), mean(2));
  EXPECT_EQ(TorusSurface<double>::traits.default_cost, static_cast<unsigned>(std::ceil(mean(0) / 6)));
}

}  // namespace
}  // namespace pyrasim
