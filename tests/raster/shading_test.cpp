// SPDX-License-Identifier: Apache-2.0
#include "raster/shading.h"

#include <gtest/gtest.h>

#include <random>

namespace pyrasim {
namespace {

TEST(Shading, KeepsAFactorBitForBit) {
  for (const double factor : {0.0, 1.0, 0.1, 1.0 / 3, 0x1p-60}) EXPECT_EQ(Shading(factor).factor(), factor);
  EXPECT_EQ(Shading().factor(), 1);
}

TEST(Shading, KeepsSimpleLightBitForBit) {
  for (const glm::dvec3& light : {glm::dvec3(0), glm::dvec3(1), glm::dvec3(1, 0, 0.5), glm::dvec3(4095, 7, 0),
                                  glm::dvec3(0.0625, 0x1p-23, 0), glm::dvec3(2, 3, 0.25)}) {
    EXPECT_EQ(Shading(light).light(), light) << light.x << " " << light.y << " " << light.z;
  }
}

/// By 2^-21 of the largest component, or by 2^-24.
TEST(Shading, ErrsByHalfAUnitOfTheLargestComponent) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> exponent(-26, 11.9);
  double worst = 0;
  for (int k = 0; k < 100'000; ++k) {
    const glm::dvec3 light(std::exp2(exponent(random)), std::exp2(exponent(random)), std::exp2(exponent(random)));
    const double bound = std::max(0x1p-21 * std::max({light.x, light.y, light.z}), 0x1p-24);
    const glm::dvec3 kept = Shading(light).light();
    for (int c = 0; c < 3; ++c) worst = std::max(worst, std::abs(kept[c] - light[c]) / bound);
  }
  EXPECT_LE(worst, 2) << "a power of two has twice the relative unit";
  EXPECT_GT(worst, 0.9);
}

TEST(Shading, IsNoBrighterThanItCanSay) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double bright : {4096.0, 1e9, infinity}) {
    EXPECT_EQ(Shading(glm::dvec3(bright, 0, 1)).light(), glm::dvec3(Shading::largest_light, 0, 1));
  }
}

/// Where rounding carries into the next power of two, the unit grows with it.
TEST(Shading, RoundsUpToPowersOfTwo) {
  for (int exponent = -2; exponent <= 11; ++exponent) {
    const double power = std::exp2(exponent);
    EXPECT_EQ(Shading(glm::dvec3(power * (1 - 0x1p-40), power, 0)).light(), glm::dvec3(power, power, 0)) << exponent;
    EXPECT_EQ(Shading(glm::dvec3(power * (1 - 0x1p-40))).light(), glm::dvec3(power)) << exponent;
  }
}

}  // namespace
}  // namespace pyrasim
