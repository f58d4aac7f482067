// SPDX-License-Identifier: Apache-2.0
#include "surface/box.h"

#include <gtest/gtest.h>

namespace pyrasim {
namespace {

template <class Scalar>
class BoxOf : public testing::Test {
 protected:
  using V = Vector<Scalar>;
  /// Along the axes, of the observer at the origin.
  static BoxSurface<Scalar> box(const V& min, const V& max) {
    return {{{{{1, 0, 0}, min.x, max.x}, {{0, 1, 0}, min.y, max.y}, {{0, 0, 1}, min.z, max.z}}}};
  }
  static Scalar hit(const V& min, const V& max, const V& direction) {
    return box(min, max).intersect(ViewRay<Scalar>(direction));
  }
};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(BoxOf, Scalars);

TYPED_TEST(BoxOf, HandComputed) {
  EXPECT_EQ(this->hit({2, -1, -1}, {4, 1, 1}, {1, 0, 0}), 2);      // parallel to two pairs of faces
  EXPECT_EQ(this->hit({2, 1, -1}, {8, 3, 1}, {1, 0.25, 0}), 4);    // from below, through y = 1
  EXPECT_EQ(this->hit({2, 1, -1}, {8, 3, 1}, {1, 0.0625, 0}), 0);  // under it
  EXPECT_EQ(this->hit({2, -1, -1}, {4, 1, 1}, {1, 0, 0.75}), 0);   // past it
  EXPECT_EQ(this->hit({2, -3, -1}, {4, -1, 1}, {1, 0, 0}), 0);     // parallel, above it
}

TYPED_TEST(BoxOf, EdgesAndFacesBelongToIt) {
  EXPECT_EQ(this->hit({2, -1, -1}, {4, 1, 1}, {1, 0.5, 0}), 2);   // where x = 2 meets y = 1
  EXPECT_EQ(this->hit({2, 0, -1}, {4, 1, 1}, {1, 0, 0}), 2);      // in the plane of a face
  EXPECT_EQ(this->hit({2, -1, -1}, {4, 1, 1}, {1, 0.25, 0}), 2);  // out again through an edge
}

TYPED_TEST(BoxOf, FromInsideItIsTheWayOut) {
  EXPECT_EQ(this->hit({-2, -1, -1}, {4, 1, 1}, {1, 0, 0}), 4);
  EXPECT_EQ(this->hit({-2, -1, -1}, {4, 1, 1}, {1, -0.5, 0}), 2);
  EXPECT_EQ(this->hit({0, -1, -1}, {4, 1, 1}, {1, 0, 0}), 4);  // he does not see the face that he stands on
}

TYPED_TEST(BoxOf, BehindIsNoHit) { EXPECT_EQ(this->hit({-4, -1, -1}, {-2, 1, 1}, {1, 0, 0}), 0); }

/// Each face by its own normal, on the side that is seen.
TYPED_TEST(BoxOf, IsLitFaceByFace) {
  using Scalar = TypeParam;
  const Lighting<double> lighting{true, 0.25, {-0.5, 0.75, 0.125}};
  const auto shading = rounded<Scalar>(BoxShading<double>{
      {flat_shading({1, 0, 0}, lighting), flat_shading({0, 1, 0}, lighting), flat_shading({0, 0, 1}, lighting)}});
  const auto lit = [&](const BoxSurface<Scalar>& box, const Vector<Scalar>& direction) {
    const Scalar t = box.intersect(ViewRay<Scalar>(direction));
    return box.shade(shading, Lighting<Scalar>{}, direction, t);
  };
  EXPECT_EQ(lit(this->box({2, -3, -1}, {4, -1, 1}), {1, -0.75, 0}), Scalar(0.25 + 0.75 * 0.5));    // x = 2
  EXPECT_EQ(lit(this->box({2, -3, -1}, {4, -1, 1}), {1, -0.375, 0}), Scalar(0.25 + 0.75 * 0.75));  // y = -1
  EXPECT_EQ(lit(this->box({2, -1, -4}, {9, 1, -1}), {1, 0, -0.25}), Scalar(0.25 + 0.75 * 0.125));  // z = -1
  EXPECT_EQ(lit(this->box({2, 1, -1}, {9, 4, 1}), {1, 0.25, 0}), Scalar(0.25));                    // y = 1, in the dark
  EXPECT_EQ(lit(this->box({-2, -1, -1}, {4, 1, 1}), {1, 0, 0}), Scalar(0.25 + 0.75 * 0.5));        // x = 4, from inside
}

}  // namespace
}  // namespace pyrasim
