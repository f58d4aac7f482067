// SPDX-License-Identifier: Apache-2.0
#include "surface/slope_bounds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "../test_scenes.h"
#include "camera/observer_frame.h"

namespace pyrasim {
namespace {

/// Whether the bounds hold the point, for all of its that is to be seen.
testing::AssertionResult hold(const BoundingBox& seen, const glm::dvec3& point) {
  if (point.x <= 0) return testing::AssertionSuccess();
  const glm::dvec3 place(point.x, point.y / point.x, point.z / point.x);
  for (int axis = 0; axis < 3; ++axis) {
    if (!(seen.lower[axis] <= place[axis] && place[axis] <= seen.upper[axis])) {
      return testing::AssertionFailure() << "axis " << axis << ": " << place[axis] << " outside " << seen.lower[axis]
                                         << " to " << seen.upper[axis];
    }
  }
  return testing::AssertionSuccess();
}

TEST(SeenBounds, HoldEveryPointOfASphereAndTouchIt) {
  std::mt19937_64 random(11);
  int finite = 0;
  for (int sphere = 0; sphere < 300; ++sphere) {
    const glm::dvec3 center = random_vector(random, glm::dvec3(-4), glm::dvec3(4));
    const double radius = std::uniform_real_distribution<double>(0.1, 3)(random);
    const BoundingBox seen = slope_bounds_of_sphere(center, radius, 1e-12);
    double highest = -std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3000; ++k) {
      const double angle = k * (std::acos(-1) / 1500);  // the great circle in the plane z = centre's z
      const glm::dvec3 rim = center + radius * glm::dvec3(std::cos(angle), std::sin(angle), 0);
      if (rim.x > 0) highest = std::max(highest, rim.y / rim.x);
      ASSERT_TRUE(hold(seen, rim));
      const glm::dvec3 direction = normalized(random_vector(random, glm::dvec3(-1), glm::dvec3(1)));
      ASSERT_TRUE(hold(seen, center + radius * direction));
    }
    if (center.x - radius < 0.1) continue;
    ++finite;
    EXPECT_NEAR(seen.upper.y, highest, 1e-3 * (1 + highest * highest) / (center.x - radius));
  }
  EXPECT_GT(finite, 50);
}

TEST(SeenBounds, OfASphereByHand) {
  const BoundingBox seen = slope_bounds_of_sphere({5, 0, 0}, 3, 0);  // a tangent of length 4
  EXPECT_EQ(seen.lower, glm::dvec3(2, -0.75, -0.75));
  EXPECT_EQ(seen.upper, glm::dvec3(8, 0.75, 0.75));
}

/// The horizon of a ground that reaches behind the observer is a bound on one side only.
TEST(SeenBounds, OfASphereThatReachesBehind) {
  for (const double x : {-50.0, 0.0, 50.0}) {
    const BoundingBox seen = slope_bounds_of_sphere({x, -101, 0}, 100, 0);
    EXPECT_GT(seen.upper.y, -2);
    EXPECT_LT(seen.upper.y, 0);
    EXPECT_EQ(seen.lower.y, -std::numeric_limits<double>::infinity());
    EXPECT_EQ(seen.upper.z, std::numeric_limits<double>::infinity());
  }
}

TEST(SeenBounds, OfASurfaceBehindAreEmpty) {
  EXPECT_EQ(slope_bounds_of_sphere({-2, 0, 0}, 1, 0).frontal_area(), 0);
  const BoundingBox triangle =
      slope_bounds_of_hull(std::array<glm::dvec3, 3>{{{-1, 0, 0}, {-2, 1, 0}, {-1, 0, 1}}}, 1e-3);
  EXPECT_FALSE(triangle.lower.x <= triangle.upper.x);
}

TEST(SeenBounds, HoldEveryPointOfATriangle) {
  std::mt19937_64 random(12);
  for (int triangle = 0; triangle < 1000; ++triangle) {
    std::array<glm::dvec3, 3> vertices;
    for (glm::dvec3& vertex : vertices) vertex = random_vector(random, glm::dvec3(-1, -3, -3), glm::dvec3(5, 3, 3));
    const BoundingBox seen = slope_bounds_of_hull(vertices, 1e-12);
    for (int k = 0; k < 200; ++k) {
      glm::dvec3 weights = random_vector(random, glm::dvec3(0), glm::dvec3(1));
      weights /= weights.x + weights.y + weights.z;
      ASSERT_TRUE(hold(seen, weights.x * vertices[0] + weights.y * vertices[1] + weights.z * vertices[2]));
    }
    for (const glm::dvec3& vertex : vertices) ASSERT_TRUE(hold(seen, vertex));
  }
}

TEST(SeenBounds, MarginGrowsThem) {
  const std::array<glm::dvec3, 3> vertices{{{2, 0, 0}, {2, 1, 0}, {2, 0, 1}}};
  const BoundingBox seen = slope_bounds_of_hull(vertices, 0.5);
  EXPECT_EQ(seen.lower, glm::dvec3(1.5, -0.5 / 1.5, -0.5 / 1.5));
  EXPECT_EQ(seen.upper, glm::dvec3(2.5, 1, 1));
}

TEST(SeenBounds, OnScreenIsFinite) {
  const Screen screen{8, 4, 2, 0.5, 0.5};  // slopes up to 0.5 and 1
  const double infinity = std::numeric_limits<double>::infinity();
  const BoundingBox wide = on_screen({{1, -infinity, 0.25}, {2, infinity, infinity}}, screen);
  EXPECT_EQ(wide.lower, glm::dvec3(1, -0.5, 0.25));
  EXPECT_EQ(wide.upper, glm::dvec3(2, 0.5, 1));
  EXPECT_EQ(on_screen({{1, 2, 0}, {2, 3, 1}}, screen).frontal_area(), 0);
  const BoundingBox nothing = on_screen(BoundingBox(), screen);
  EXPECT_EQ(nothing.frontal_area(), 0);
  EXPECT_TRUE(std::isfinite(nothing.center().x + nothing.center().y + nothing.center().z));
}

}  // namespace
}  // namespace pyrasim
