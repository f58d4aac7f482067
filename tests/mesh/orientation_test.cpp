// SPDX-License-Identifier: Apache-2.0
// On which side of a line a point lies, against integers: coordinates are multiples of 2^-53, their products fit 128
// bits.
#include "mesh/orientation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace pyrasim {
namespace {

__extension__ using Wide = __int128;

/// Twice the triangle's signed area, in units of 2^-106.
int exact_orientation(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  const auto whole = [](double coordinate) { return static_cast<Wide>(std::ldexp(coordinate, 53)); };
  const Wide left = (whole(a.x) - whole(c.x)) * (whole(b.y) - whole(c.y));
  const Wide right = (whole(a.y) - whole(c.y)) * (whole(b.x) - whole(c.x));
  return (left > right) - (left < right);
}

/// Points next to the diagonal through (12, 12) and (24, 24), a last place apart: with rounded products many of them
/// come to lie on the wrong side (Kettner, Mehlhorn, Pion, Schirra, Yap, Classroom Examples of Robustness Problems in
/// Geometric Computations, 2008).
TEST(Orientation, IsExactNextToALine) {
  const glm::dvec2 b(12, 12);
  const glm::dvec2 c(24, 24);
  int on_the_line = 0;
  int rounding_misleads = 0;
  for (int i = 0; i < 64; ++i) {
    for (int j = 0; j < 64; ++j) {
      const glm::dvec2 a(0.5 + std::ldexp(i, -53), 0.5 + std::ldexp(j, -53));
      const int expected = exact_orientation(a, b, c);
      ASSERT_EQ(orientation(a, b, c), expected) << i << " " << j;
      ASSERT_EQ(orientation(b, c, a), expected) << i << " " << j;
      ASSERT_EQ(orientation(b, a, c), -expected) << i << " " << j;
      on_the_line += expected == 0 ? 1 : 0;
      const double rounded = (a.x - c.x) * (b.y - c.y) - (a.y - c.y) * (b.x - c.x);
      rounding_misleads += (rounded > 0) - (rounded < 0) != expected ? 1 : 0;
    }
  }
  EXPECT_GE(on_the_line, 32);
  EXPECT_GT(rounding_misleads, 100);
}

TEST(Orientation, IsThatOfTheIntegersAnywhere) {
  std::mt19937_64 random(9);
  const auto point = [&] {
    const auto coordinate = [&] { return std::ldexp(static_cast<double>(random() % (1U << 30U)), -30); };
    const double x = coordinate();
    return glm::dvec2(x, coordinate());
  };
  for (int k = 0; k < 10'000; ++k) {
    const glm::dvec2 a = point();
    const glm::dvec2 b = point();
    const glm::dvec2 c = k % 2 == 0 ? point() : (a + b) / 2.0;
    ASSERT_EQ(orientation(a, b, c), exact_orientation(a, b, c)) << k;
  }
}

}  // namespace
}  // namespace pyrasim
