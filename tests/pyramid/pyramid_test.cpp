// SPDX-License-Identifier: Apache-2.0
#include "pyramid/pyramid.h"

#include <gtest/gtest.h>

namespace pyrasim {
namespace {

std::array<GridPoint, 4> corner_points(const Pyramid& pyramid, int max_level) {
  const std::uint32_t s = side(pyramid.level, max_level);
  const auto [row, column] = pyramid.corner;
  return {{{row, column}, {row, column + s}, {row + s, column}, {row + s, column + s}}};
}

/// A sample that tells where it was taken.
Sample sample_at(GridPoint point) { return {point.row * 100'000 + point.column, 1}; }

CornerSamples samples_at(const std::array<GridPoint, 4>& points) {
  return {sample_at(points[0]), sample_at(points[1]), sample_at(points[2]), sample_at(points[3])};
}

TEST(Pyramid, SideHalvesWithEveryLevel) {
  EXPECT_EQ(side(0, 0), 1U);
  EXPECT_EQ(side(0, 3), 8U);
  EXPECT_EQ(side(1, 3), 4U);
  EXPECT_EQ(side(3, 3), 1U);
  EXPECT_EQ(side(0, max_level_limit), 65536U);
}

TEST(Pyramid, SubdivisionPointsByHand) {
  const Pyramid pixel{{16, 40}, 0};  // at MAX_LEVEL 3 its side is 8
  EXPECT_EQ(subdivision_point(pixel, top_middle, 3), (GridPoint{16, 44}));
  EXPECT_EQ(subdivision_point(pixel, left_middle, 3), (GridPoint{20, 40}));
  EXPECT_EQ(subdivision_point(pixel, center, 3), (GridPoint{20, 44}));
  EXPECT_EQ(subdivision_point(pixel, right_middle, 3), (GridPoint{20, 48}));
  EXPECT_EQ(subdivision_point(pixel, bottom_middle, 3), (GridPoint{24, 44}));
}

TEST(Pyramid, SubpixelsByHand) {
  const Pyramid parent{{16, 40}, 1};  // side 4
  const std::array<GridPoint, 4> corners{{{16, 40}, {16, 42}, {18, 40}, {18, 42}}};
  for (std::size_t child = 0; child < 4; ++child) {
    EXPECT_EQ(subpixel(parent, child, 3).corner, corners[child]);
    EXPECT_EQ(subpixel(parent, child, 3).level, 2U);
  }
}

/// What subpixel_corners puts together is what was sampled at the subpixel's own corner addresses.
TEST(Pyramid, SubpixelCornersAreTheSamplesAtTheirAddresses) {
  for (int max_level = 1; max_level <= 6; ++max_level) {
    for (std::uint32_t level = 0; level < static_cast<std::uint32_t>(max_level); ++level) {
      const Pyramid parent{{3U << max_level, 5U << max_level}, level};
      const CornerSamples corners = samples_at(corner_points(parent, max_level));
      SubdivisionSamples middle;
      for (std::size_t k = 0; k < subdivision_rays; ++k) {
        middle[k] = sample_at(subdivision_point(parent, k, max_level));
      }
      for (std::size_t child = 0; child < 4; ++child) {
        EXPECT_EQ(subpixel_corners(corners, middle, child),
                  samples_at(corner_points(subpixel(parent, child, max_level), max_level)));
      }
    }
  }
}

/// The order in which rays are traced: the third completes subpixel 0, the fourth 1, the fifth 2 and 3.
TEST(Pyramid, SubpixelsNeedNoSampleThatComesLater) {
  const SubdivisionSamples middle{{{0, 1}, {1, 1}, {2, 1}, {3, 1}, {4, 1}}};
  const CornerSamples outer{{{10, 1}, {10, 1}, {10, 1}, {10, 1}}};
  const std::array<std::uint32_t, 4> last{2, 3, 4, 4};
  for (std::size_t child = 0; child < 4; ++child) {
    std::uint32_t latest = 0;
    for (const Sample& corner : subpixel_corners(outer, middle, child)) {
      if (corner.object < 10) latest = std::max(latest, corner.object);
    }
    EXPECT_EQ(latest, last[child]);
  }
}

TEST(Pyramid, AddressesFitThirtyTwoBits) {
  EXPECT_TRUE(addressable(max_screen_size, 1, max_level_limit));
  EXPECT_TRUE(addressable(1, max_screen_size, max_level_limit));
  EXPECT_FALSE(addressable(max_screen_size + 1, 1, max_level_limit));
  EXPECT_TRUE(addressable(640, 480, 0));
}

}  // namespace
}  // namespace pyrasim
