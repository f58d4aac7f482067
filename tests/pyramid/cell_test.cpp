// SPDX-License-Identifier: Apache-2.0
#include "pyramid/cell.h"

#include <gtest/gtest.h>

namespace pyrasim {
namespace {

std::array<GridPoint, 4> corner_points(const Cell& cell) {
  const std::uint32_t s = side(cell);
  const auto [row, column] = cell.corner;
  return {{{row, column}, {row, column + s}, {row + s, column}, {row + s, column + s}}};
}

/// A sample that tells where it was taken.
Sample sample_at(GridPoint point) { return {{point.row * 100'000 + point.column}}; }

CornerSamples samples_at(const std::array<GridPoint, 4>& points) {
  return {sample_at(points[0]), sample_at(points[1]), sample_at(points[2]), sample_at(points[3])};
}

TEST(Cell, LevelsCountFromThePixel) {
  const PixelWindow window{.column = 2, .row = 1, .columns = 9, .rows = 9};
  const Cell pixel = pixel_cell(window, 1, 3, 3);
  EXPECT_EQ(pixel.corner, (GridPoint{16, 40}));
  EXPECT_EQ(side(pixel), 8U);
  EXPECT_EQ(level_of(pixel.log2_side, 3), 0U);
  EXPECT_EQ(level_of(subpixel(pixel, 0).log2_side, 3), 1U);
  EXPECT_EQ(side(pixel_cell(window, 0, 0, 0)), 1U);
  EXPECT_EQ(side(pixel_cell(window, 0, 0, max_level_limit)), 65536U);
}

TEST(Cell, SubdivisionPointsByHand) {
  const Cell pixel{{16, 40}, 3};  // of side 8
  EXPECT_EQ(subdivision_point(pixel, top_middle), (GridPoint{16, 44}));
  EXPECT_EQ(subdivision_point(pixel, left_middle), (GridPoint{20, 40}));
  EXPECT_EQ(subdivision_point(pixel, center), (GridPoint{20, 44}));
  EXPECT_EQ(subdivision_point(pixel, right_middle), (GridPoint{20, 48}));
  EXPECT_EQ(subdivision_point(pixel, bottom_middle), (GridPoint{24, 44}));
}

TEST(Cell, SubpixelsByHand) {
  const Cell parent{{16, 40}, 2};  // of side 4
  const std::array<GridPoint, 4> corners{{{16, 40}, {16, 42}, {18, 40}, {18, 42}}};
  for (std::size_t child = 0; child < 4; ++child) {
    EXPECT_EQ(subpixel(parent, child).corner, corners[child]);
    EXPECT_EQ(side(subpixel(parent, child)), 2U);
  }
}

/// What subpixel_corners puts together is what was sampled at the subpixel's own corner addresses.
TEST(Cell, SubpixelCornersAreTheSamplesAtTheirAddresses) {
  for (std::uint32_t log2_side = 1; log2_side <= 6; ++log2_side) {
    const Cell parent{{3U << 6U, 5U << 6U}, log2_side};
    const CornerSamples corners = samples_at(corner_points(parent));
    SubdivisionSamples middle;
    for (std::size_t k = 0; k < subdivision_rays; ++k) middle[k] = sample_at(subdivision_point(parent, k));
    for (std::size_t child = 0; child < 4; ++child) {
      EXPECT_EQ(subpixel_corners(corners, middle, child), samples_at(corner_points(subpixel(parent, child))));
    }
  }
}

/// The order in which rays are traced: the third completes subpixel 0, the fourth 1, the fifth 2 and 3.
TEST(Cell, SubpixelsNeedNoSampleThatComesLater) {
  const SubdivisionSamples middle{{{{0}}, {{1}}, {{2}}, {{3}}, {{4}}}};
  const CornerSamples outer{{{{10}}, {{10}}, {{10}}, {{10}}}};
  const std::array<std::uint32_t, 4> last{2, 3, 4, 4};
  for (std::size_t child = 0; child < 4; ++child) {
    std::uint32_t latest = 0;
    for (const Sample& corner : subpixel_corners(outer, middle, child)) {
      if (corner.seen.object < 10) latest = std::max(latest, corner.seen.object);
    }
    EXPECT_EQ(latest, last[child]);
  }
}

TEST(Cell, AddressesFitThirtyTwoBits) {
  EXPECT_TRUE(addressable(max_screen_size, 1, max_level_limit));
  EXPECT_TRUE(addressable(1, max_screen_size, max_level_limit));
  EXPECT_FALSE(addressable(max_screen_size + 1, 1, max_level_limit));
  EXPECT_TRUE(addressable(640, 480, 0));
}

}  // namespace
}  // namespace pyrasim
