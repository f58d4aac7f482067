// SPDX-License-Identifier: Apache-2.0
#include "surface/sphere.h"

#include <gtest/gtest.h>

namespace pyrasim {
namespace {

template <class Scalar>
class SphereOf : public testing::Test {
 protected:
  using V = Vector<Scalar>;

  /// t of the ray along `direction`; exact input gives exact intermediate values in all of these cases.
  static Scalar hit(const V& center, Scalar radius, const V& direction) {
    const Scalar power = dot(center, center) - radius * radius;
    const SphereSurface<Scalar> sphere{center, radius * radius, power, radius, {0, 0}};
    return sphere.intersect(ViewRay<Scalar>(direction));
  }
};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(SphereOf, Scalars);

TYPED_TEST(SphereOf, NearerRootFromOutside) {
  EXPECT_EQ(this->hit({5, 0, 0}, 1, {1, 0, 0}), 4);
  EXPECT_EQ(this->hit({5, 0, 0}, 1, {2, 0, 0}), 2);
  EXPECT_EQ(this->hit({0, -8, 0}, 2, {0, -0.5, 0}), 12);
  // |(3, 4, 0) t - (6, 8, 0)| = 5 at t = 1 and t = 3.
  EXPECT_NEAR(this->hit({6, 8, 0}, 5, {3, 4, 0}), 1, 4 * epsilon<TypeParam>());
  // Off the middle: centre (5, 3, 0), radius 5, ray along x: 5 - sqrt(25 - 9) = 1.
  EXPECT_NEAR(this->hit({5, 3, 0}, 5, {1, 0, 0}), 1, 8 * epsilon<TypeParam>());
}

TYPED_TEST(SphereOf, FarRootFromInside) {
  EXPECT_EQ(this->hit({0, 0, 0}, 2, {1, 0, 0}), 2);
  EXPECT_EQ(this->hit({1, 0, 0}, 2, {1, 0, 0}), 3);
  EXPECT_EQ(this->hit({1, 0, 0}, 2, {-1, 0, 0}), 1);
  EXPECT_EQ(this->hit({0, 3, 0}, 5, {4, 0, 0}), 1);
}

TYPED_TEST(SphereOf, BehindIsNoHit) {
  EXPECT_EQ(this->hit({-5, 0, 0}, 1, {1, 0, 0}), 0);
  EXPECT_EQ(this->hit({5, 0, 0}, 1, {-1, 0, 0}), 0);
  EXPECT_EQ(this->hit({0, 5, 0}, 1, {1, 0, 0}), 0);
}

TYPED_TEST(SphereOf, TangentTouchesAndBeyondMisses) {
  EXPECT_EQ(this->hit({5, 1, 0}, 1, {1, 0, 0}), 5);
  EXPECT_EQ(this->hit({5, 0, -2}, 2, {1, 0, 0}), 5);
  EXPECT_EQ(this->hit({5, 1 + 4 * epsilon<TypeParam>(), 0}, 1, {1, 0, 0}), 0);
  EXPECT_EQ(this->hit({5, 3, 0}, 1, {1, 0, 0}), 0);
}

TYPED_TEST(SphereOf, OriginOnTheSurface) {
  EXPECT_EQ(this->hit({1, 0, 0}, 1, {1, 0, 0}), 2);   // across the sphere
  EXPECT_EQ(this->hit({1, 0, 0}, 1, {-1, 0, 0}), 0);  // away from it
  EXPECT_EQ(this->hit({1, 0, 0}, 1, {0, 1, 0}), 0);   // along it
}

/// A small far sphere: b^2 - 4ac would lose the radius altogether.
TYPED_TEST(SphereOf, FarSphereKeepsItsOutline) {
  const TypeParam far = 1 << 20;
  EXPECT_EQ(this->hit({far, TypeParam(0.5), 0}, TypeParam(0.5), {1, 0, 0}), far);
  EXPECT_EQ(this->hit({far, TypeParam(0.5) + epsilon<TypeParam>(), 0}, TypeParam(0.5), {1, 0, 0}), 0);
}

TYPED_TEST(SphereOf, LengthOfTheDirectionOnlyScalesT) {
  for (const int power : {-20, -3, 1, 17}) {
    const TypeParam scale = std::ldexp(TypeParam(1), power);
    const Vector<TypeParam> direction{1, TypeParam(0.3), TypeParam(-0.2)};
    const TypeParam t = this->hit({7, 2, -1}, 1, direction);
    ASSERT_GT(t, 0);
    EXPECT_EQ(this->hit({7, 2, -1}, 1, direction * scale), t / scale);
  }
}

}  // namespace
}  // namespace pyrasim
