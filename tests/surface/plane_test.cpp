// SPDX-License-Identifier: Apache-2.0
#include "surface/plane.h"

#include <gtest/gtest.h>

namespace pyrasim {
namespace {

template <class Scalar>
class PlaneOf : public testing::Test {
 protected:
  using V = Vector<Scalar>;
  static Scalar hit(const V& normal, Scalar offset, const V& direction) {
    return PlaneSurface<Scalar>{normal, offset}.intersect(ViewRay<Scalar>(direction));
  }
};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(PlaneOf, Scalars);

TYPED_TEST(PlaneOf, HandComputed) {
  EXPECT_EQ(this->hit({1, 0, 0}, 3, {1, 0, 0}), 3);
  EXPECT_EQ(this->hit({-1, 0, 0}, -3, {1, 0, 0}), 3);  // either side counts
  EXPECT_EQ(this->hit({0, 1, 0}, 2, {1, 1, 0}), 2);
  EXPECT_EQ(this->hit({0, 1, 0}, -1, {1, -0.5, 0}), 2);
}

TYPED_TEST(PlaneOf, BehindIsNoHit) {
  EXPECT_EQ(this->hit({1, 0, 0}, -3, {1, 0, 0}), 0);
  EXPECT_EQ(this->hit({0, 1, 0}, -1, {1, 0.5, 0}), 0);
}

TYPED_TEST(PlaneOf, ParallelIsNoHit) {
  EXPECT_EQ(this->hit({0, 1, 0}, 1, {1, 0, 0}), 0);
  EXPECT_EQ(this->hit({0, 1, 0}, 0, {1, 0, 0}), 0);
}

TYPED_TEST(PlaneOf, ThroughTheOriginIsNoHit) { EXPECT_EQ(this->hit({0, 1, 0}, 0, {1, 1, 0}), 0); }

}  // namespace
}  // namespace pyrasim
