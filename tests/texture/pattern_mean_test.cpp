// SPDX-License-Identifier: Apache-2.0
// Means over footprints against the sum over cells, each clipped by the footprint.
#include "texture/pattern_mean.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "../numeric/extremes/formats.h"
#include "texture/square_wave.h"

namespace pyrasim {
namespace {

double checker_mean(const Footprint& footprint) { return mean_of_checker(footprint).mean; }
double stripes_mean(const Footprint& footprint) { return mean_of_stripes(footprint).mean; }

using Outline = std::vector<TexturePoint>;

/// What lies on one side of a line u or v = `at`.
template <class Coordinate>
Outline clipped(const Outline& outline, Coordinate coordinate, double at, double side) {
  Outline result;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const TexturePoint& a = outline[k];
    const TexturePoint& b = outline[(k + 1) % outline.size()];
    const double of_a = side * (coordinate(a) - at);
    const double of_b = side * (coordinate(b) - at);
    if (of_a >= 0) result.push_back(a);
    if (of_a * of_b < 0) {
      const double share = of_a / (of_a - of_b);
      result.push_back({a.u + share * (b.u - a.u), a.v + share * (b.v - a.v)});
    }
  }
  return result;
}

double area(const Outline& outline) {
  double sum = 0;
  for (std::size_t k = 2; k < outline.size(); ++k) {
    const TexturePoint& a = outline[0];
    const TexturePoint& b = outline[k - 1];
    const TexturePoint& c = outline[k];
    sum += 0.5 * ((b.u - a.u) * (c.v - a.v) - (c.u - a.u) * (b.v - a.v));
  }
  return sum;
}

double mean_by_cells(const Footprint& footprint, bool checker) {
  const auto u = [](const TexturePoint& p) { return p.u; };
  const auto v = [](const TexturePoint& p) { return p.v; };
  const auto range = [&](const auto& coordinate) {
    const auto [low, high] = std::minmax_element(footprint.begin(), footprint.end(), [&](const auto& a, const auto& b) {
      return coordinate(a) < coordinate(b);
    });
    return std::pair(std::floor(coordinate(*low)), coordinate(*high));
  };
  double sum = 0;
  double all = 0;
  const auto [first_u, last_u] = range(u);
  const auto [first_v, last_v] = range(v);
  for (double i = first_u; i <= last_u; ++i) {
    const Outline column = clipped(clipped({footprint.begin(), footprint.end()}, u, i, 1), u, i + 1, -1);
    for (double j = first_v; j <= last_v; ++j) {
      const double part = area(clipped(clipped(column, v, j, 1), v, j + 1, -1));
      all += part;
      sum += part * square_wave(i) * (checker ? square_wave(j) : 1);
    }
  }
  return sum / all;
}

/// A square, its corners displaced, stretched to a parallelogram, either way around, about a place near `place`.
Footprint random_footprint(Random& random, const TexturePoint& place, double size) {
  const double long_side = size * std::exp2(random.uniform(-1, 1));
  const double short_side = long_side * std::exp2(random.uniform(-8, 0));
  const double angle = random.uniform(0, 7);
  const TexturePoint along{long_side * std::cos(angle), long_side * std::sin(angle)};
  const TexturePoint across{-short_side * std::sin(angle), short_side * std::cos(angle)};
  constexpr std::array<std::array<double, 2>, 4> square{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  Footprint footprint;
  for (std::size_t k = 0; k < 4; ++k) {
    const double x = square[k][0] - 0.5 + random.uniform(-0.2, 0.2);
    const double y = square[k][1] - 0.5 + random.uniform(-0.2, 0.2);
    footprint[k] = {place.u + x * along.u + y * across.u, place.v + x * along.v + y * across.v};
  }
  if (random.below(2) == 0) std::reverse(footprint.begin(), footprint.end());
  return footprint;
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
