// SPDX-License-Identifier: Apache-2.0
#include "surface/disc.h"

#include <gtest/gtest.h>

namespace pyrasim {
namespace {

template <class Scalar>
class DiscOf : public testing::Test {
 protected:
  using V = Vector<Scalar>;
  static Scalar hit(const V& normal, const V& center, Scalar radius, const V& direction) {
    const DiscSurface<Scalar> disc{normal, dot(normal, center), center, radius * radius};
    return disc.intersect(ViewRay<Scalar>(direction));
  }
};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(DiscOf, Scalars);

TYPED_TEST(DiscOf, HandComputed) {
  EXPECT_EQ(this->hit({1, 0, 0}, {4, 0, 0}, 1, {1, 0, 0}), 4);
  EXPECT_EQ(this->hit({-2, 0, 0}, {4, 0, 0}, 1, {1, 0, 0}), 4);          // either side, any length
  EXPECT_EQ(this->hit({0, 1, 0}, {4, -1, 0}, 2, {1, -0.25, 0}), 4);      // from above
  EXPECT_EQ(this->hit({0, 1, 0}, {4, -1, 0}, 2, {1, -0.25, 0.375}), 4);  // 1.5 beside its middle
  EXPECT_EQ(this->hit({0, 1, 0}, {4, -1, 0}, 2, {1, -0.25, 0.625}), 0);  // 2.5 beside it
}

TYPED_TEST(DiscOf, TheRimBelongsToIt) {
  EXPECT_EQ(this->hit({1, 0, 0}, {4, 0, 0}, 1, {1, 0.25, 0}), 4);
  EXPECT_EQ(this->hit({1, 0, 0}, {4, 0, 0}, 1, {1, 0.2500001F, 0}), 0);
}

TYPED_TEST(DiscOf, BehindAndAlongIsNoHit) {
  EXPECT_EQ(this->hit({1, 0, 0}, {-4, 0, 0}, 9, {1, 0, 0}), 0);
  EXPECT_EQ(this->hit({0, 1, 0}, {4, 0, 0}, 1, {1, 0, 0}), 0);
}

/// The point of the rim on any side lies within the bounds, and not far from them.
TEST(DiscBounds, HoldTheRim) {
  const DiscSurface<double> disc{{1, 0.5, -0.25}, 5.25, {5, 1, 1}, 0.25};
  const auto bounds = slope_bounds(disc, 1e-9);
  ASSERT_TRUE(bounds);
  const glm::dvec3 along = normalized(cross(disc.normal, glm::dvec3(0, 0, 1)));
  const glm::dvec3 across = cross(normalized(disc.normal), along);
  double lowest_slope = 1;
  for (int k = 0; k < 360; ++k) {
    const glm::dvec3 rim =
        disc.center + (along * std::cos(k * 0.0174532925) + across * std::sin(k * 0.0174532925)) * 0.5;
    EXPECT_LE(bounds->lower.x, rim.x);
    for (int axis = 1; axis < 3; ++axis) {
      EXPECT_LE(bounds->lower[axis], rim[axis] / rim.x);
      EXPECT_GE(bounds->upper[axis], rim[axis] / rim.x);
    }
    lowest_slope = std::min(lowest_slope, rim.y / rim.x);
  }
  EXPECT_GT(bounds->lower.y, lowest_slope - 0.02) << "needlessly wide";
}

}  // namespace
}  // namespace pyrasim
