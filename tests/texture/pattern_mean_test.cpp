// SPDX-License-Identifier: Apache-2.0
// Means over footprints against the sum over cells, each clipped by the footprint.
#include "texture/pattern_mean.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "clipped_area.h"
#include "texture/square_wave.h"

namespace pyrasim {
namespace {

double checker_mean(const Footprint& footprint) { return mean_of_checker(footprint).mean; }
double stripes_mean(const Footprint& footprint) { return mean_of_stripes(footprint).mean; }

double mean_by_cells(const Footprint& footprint, bool checker) {
  return mean_by_cells(footprint, [=](double i, double j) { return square_wave(i) * (checker ? square_wave(j) : 1); });
}

TEST(PatternMean, IsTheSumOverCellsWhateverTheSize) {
  Random random(5);
  for (const double size : {1e-9, 1e-6, 1e-3, 0.1, 1.0, 3.0, 30.0, 200.0}) {
    int mixed = 0;
    for (int k = 0; k < (size > 100 ? 20 : 300); ++k) {
      // Near a crossing of lines, so that small ones have two colours too.
      const TexturePoint place{std::round(random.uniform(-50, 50)) + random.uniform(-0.3, 0.3) * size,
                               std::round(random.uniform(-50, 50)) + random.uniform(-0.3, 0.3) * size};
      const Footprint footprint = random_footprint(random, place, size);
      const double checker = checker_mean(footprint);
      // The places themselves are multiples of 2^-48 or so.
      const double tolerance = 1e-10 + 1e-13 / size * 256;
      ASSERT_NEAR(checker, mean_by_cells(footprint, true), tolerance) << size << ' ' << k;
      ASSERT_NEAR(stripes_mean(footprint), mean_by_cells(footprint, false), tolerance) << size << ' ' << k;
      mixed += std::abs(checker) < 1 ? 1 : 0;
    }
    EXPECT_GT(mixed, 15) << size;
  }
}

TEST(PatternMean, OfOneCellIsItsColour) {
  EXPECT_EQ(checker_mean({{{0.1, 0.1}, {0.9, 0.1}, {0.9, 0.9}, {0.1, 0.9}}}), 1);
  EXPECT_EQ(checker_mean({{{1.1, 0.1}, {1.9, 0.1}, {1.9, 0.9}, {1.1, 0.9}}}), -1);
  EXPECT_EQ(checker_mean({{{-0.9, -0.9}, {-0.1, -0.9}, {-0.1, -0.1}, {-0.9, -0.1}}}), 1);
  EXPECT_EQ(stripes_mean({{{-0.9, 7}, {-0.1, -0.9}, {-0.1, -0.1}, {-0.9, 8}}}), -1);
}

/// No area: what the corners see. A bow tie: its two triangles.
TEST(PatternMean, OfWhatIsNoQuadrilateral) {
  EXPECT_EQ(checker_mean({{{0.5, 0.5}, {1.5, 0.5}, {0.5, 0.5}, {1.5, 0.5}}}), 0);
  EXPECT_EQ(checker_mean({{{0.5, 0.5}, {0.5, 0.5}, {0.5, 0.5}, {0.5, 0.5}}}), 1);
  EXPECT_EQ(stripes_mean({{{0.5, 0}, {1.5, 1}, {2.5, 2}, {3.5, 3}}}), 0);
  EXPECT_NEAR(checker_mean({{{0, 0}, {1, 1}, {1, 0}, {0, 1}}}), 1, 1e-12);
}

/// Thousands of cells long; a sliver along a diagonal has one colour all the way. Farther than that, the mean of both.
TEST(PatternMean, OfLongFootprintsIsFoundInNoTime) {
  const double far = 1 << 13;
  EXPECT_NEAR(checker_mean({{{0, 0}, {far, 0.25}, {far, 3.25}, {0, 3}}}), 0, 1e-4);
  EXPECT_NEAR(checker_mean({{{0.4, 0.5}, {far + 0.4, far + 0.5}, {far + 0.5, far + 0.4}, {0.5, 0.4}}}), 0.8, 0.2);
  EXPECT_EQ(checker_mean({{{0, 0}, {1e30, 0}, {1e30, 1e30}, {0, 1e30}}}), 0);
  EXPECT_NEAR(stripes_mean({{{0, 0}, {1e12, 0}, {1e12, 1e15}, {0, 1e15}}}), 0, 1e-12);
}

/// The lines of the axis of which fewer are crossed; none within a cell.
TEST(PatternMean, CountsTheLinesThatItStepsOver) {
  EXPECT_EQ(mean_of_checker({{{0.5, 0.5}, {9.5, 0.5}, {9.5, 2.5}, {0.5, 2.5}}}).lines, 4U) << "two lines, up and down";
  EXPECT_EQ(mean_of_checker({{{0.1, 0.1}, {0.9, 0.1}, {0.9, 0.9}, {0.1, 0.9}}}).lines, 0U);
  EXPECT_EQ(mean_of_stripes({{{0.5, 0.5}, {9.5, 0.5}, {9.5, 2.5}, {0.5, 2.5}}}).lines, 0U) << "a closed form each side";
}

}  // namespace
}  // namespace pyrasim
