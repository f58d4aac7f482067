// SPDX-License-Identifier: Apache-2.0
#include "camera/view_vector.h"

#include <gtest/gtest.h>

#include <cmath>

#include "numeric/number_types.h"

namespace pyrasim {
namespace {

constexpr Screen small{4, 2, 1.0, 0.5, 0.25};
constexpr Screen awkward{641, 479, 1.1, 0.1 / 3, 0.07 / 3};

template <class Scalar>
class ViewVectorsOf : public testing::Test {
 protected:
  const NumberFormat format = format_of<Scalar>();
};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(ViewVectorsOf, Scalars);

TYPED_TEST(ViewVectorsOf, CornersOfASmallScreenByHand) {
  const ViewVectors vectors(small, 1, this->format);
  using V = glm::dvec3;
  EXPECT_EQ(vectors({0, 0}), V(1, 0.5, -0.5));
  EXPECT_EQ(vectors({0, 4}), V(1, 0.5, 0.5));
  EXPECT_EQ(vectors({1, 2}), V(1, 0, 0));
  EXPECT_EQ(vectors({1, 3}), V(1, 0, 0.25));
  EXPECT_EQ(vectors({2, 0}), V(1, -0.5, -0.5));
  EXPECT_EQ(vectors({2, 4}), V(1, -0.5, 0.5));
}

TYPED_TEST(ViewVectorsOf, PointsInsideAPixelByHand) {
  const ViewVectors vectors(small, 8, this->format);  // MAX_LEVEL 3
  using V = glm::dvec3;
  EXPECT_EQ(vectors({4, 4}), V(1, 0.25, -0.375));               // the centre of pixel (0, 0)
  EXPECT_EQ(vectors({1, 0}), V(1, 0.4375, -0.5));               // an eighth of a pixel down its left side
  EXPECT_EQ(vectors({8 + 3, 16 + 5}), V(1, -0.1875, 0.15625));  // mu 1, i 3, nu 2, j 5 of level 3
}

/// Everything is a dyadic number here, so that formula (2) is exact in either order of operations.
TYPED_TEST(ViewVectorsOf, EqualFormulaTwoOnEveryPointOfEveryLevel) {
  constexpr int max_level = 3;
  const ViewVectors vectors(small, 1 << max_level, this->format);
  for (int level = 0; level <= max_level; ++level) {
    const double d = std::ldexp(1.0, -level);
    for (int row = 0; row <= small.rows << level; ++row) {
      for (int column = 0; column <= small.columns << level; ++column) {
        const double y = small.rows / 2.0 * small.dy - row * d * small.dy;
        const double z = -small.columns / 2.0 * small.dz + column * d * small.dz;
        const auto mu = static_cast<std::uint32_t>(row << (max_level - level));
        const auto nu = static_cast<std::uint32_t>(column << (max_level - level));
        EXPECT_EQ(vectors({mu, nu}), glm::dvec3(1, y, z)) << level << " " << row << " " << column;
      }
    }
  }
}

/// Decision D8: one point is one view vector, bit for bit, at whatever MAX_LEVEL it is addressed.
TYPED_TEST(ViewVectorsOf, OnePointIsOneVectorOnEveryGrid) {
  const ViewVectors coarse(awkward, 1, this->format);
  const ViewVectors middle(awkward, 8, this->format);
  for (int max_level = 1; max_level <= 16; ++max_level) {
    const ViewVectors fine(awkward, 1LL << max_level, this->format);
    for (std::uint32_t k = 0; k <= 479; k += 7) {
      const GridPoint point{k, 641 - k};
      EXPECT_EQ(fine({point.row << max_level, point.column << max_level}), coarse(point));
      if (max_level < 3) continue;
      const int shift = max_level - 3;
      EXPECT_EQ(fine({(8 * k + 3) << shift, (8 * k + 5) << shift}), middle({8 * k + 3, 8 * k + 5}));
    }
  }
}

TYPED_TEST(ViewVectorsOf, OddScreensAreSymmetricAboutTheAxis) {
  const ViewVectors vectors(awkward, 4, this->format);
  for (std::uint32_t k = 0; k <= 4 * 479; ++k) {
    const glm::dvec3 upper = vectors({k, k});
    const glm::dvec3 lower = vectors({4 * 479 - k, 4 * 641 - k});
    EXPECT_EQ(upper.y, -lower.y);
    EXPECT_EQ(upper.z, -lower.z);
  }
}

TYPED_TEST(ViewVectorsOf, LargeScreenIsMonotoneWithoutDuplicates) {
  const Screen large{max_screen_size, max_screen_size, 1.3, 0.1 / max_screen_size, 0.7 / max_screen_size};
  const ViewVectors vectors(large, 16, this->format);
  glm::dvec3 last = vectors({0, 0});
  for (std::uint32_t k = 1; k <= 16U * max_screen_size; ++k) {
    const glm::dvec3 next = vectors({k, k});
    ASSERT_LT(next.y, last.y) << k;
    ASSERT_GT(next.z, last.z) << k;
    last = next;
  }
}

TEST(ViewVectors, LargestScreenAtTheDeepestLevelStaysMonotone) {
  const Screen large{max_screen_size, max_screen_size, 1.3, 0.1 / max_screen_size, 0.7 / max_screen_size};
  const ViewVectors vectors(large, 1 << 16);
  constexpr std::uint32_t end = static_cast<std::uint32_t>(max_screen_size) << 16U;
  for (const std::uint32_t start : {0U, end / 3, end / 2 - 5000, end - 10000}) {
    for (std::uint32_t k = start; k < start + 10000; ++k) {
      ASSERT_LT(vectors({k + 1, 0}).y, vectors({k, 0}).y) << k;
      ASSERT_GT(vectors({0, k + 1}).z, vectors({0, k}).z) << k;
    }
  }
}

}  // namespace
}  // namespace pyrasim
