// SPDX-License-Identifier: Apache-2.0
#include "pyramid/max_level.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pyrasim {
namespace {

TEST(RequiredMaxLevel, ArticlesDisplayNeedsThree) {
  EXPECT_EQ(required_max_level(std::ldexp(1, -10)), 3);
  EXPECT_EQ(required_max_level(std::ldexp(1, -10), std::ldexp(1, -13)), 3);
}

TEST(RequiredMaxLevel, PowersOfTwoAreExact) {
  for (int level = 0; level <= 16; ++level) {
    EXPECT_EQ(required_max_level(std::ldexp(1, level - 13)), level);
    EXPECT_EQ(required_max_level(std::ldexp(1, level - 13) * 1.001), level + 1);
    EXPECT_EQ(required_max_level(std::ldexp(1, level - 13) * 0.999), level);
  }
}

TEST(RequiredMaxLevel, FinerThanTheEyeIsZero) {
  EXPECT_EQ(required_max_level(std::ldexp(1, -13)), 0);
  EXPECT_EQ(required_max_level(std::ldexp(1, -14)), 0);
  EXPECT_EQ(required_max_level(1e-9), 0);
}

TEST(PixelAngle, ByHand) {
  EXPECT_DOUBLE_EQ(pixel_angle(2.0, 1.0), std::acos(-1) / 2);  // 45 degrees to either side
  EXPECT_NEAR(pixel_angle(0.25e-3, 0.5), 0.5e-3, 1e-10);       // a quarter of a millimetre at half a metre
  EXPECT_DOUBLE_EQ(pixel_angle(Screen{4, 4, 2.0, 0.125, 0.5}), pixel_angle(0.5, 2.0));
  EXPECT_DOUBLE_EQ(pixel_angle(Screen{4, 4, 2.0, 0.75, 0.5}), pixel_angle(0.75, 2.0));
}

}  // namespace
}  // namespace pyrasim
