// SPDX-License-Identifier: Apache-2.0
#include "mesh/triangulate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "polygons.h"

namespace pyrasim {
namespace {

/// Where a polygon of the plane lies in space. Lengths are multiplied by `scale`.
struct Placement {
  glm::dvec3 origin{0, 0, 0};
  glm::dvec3 x{1, 0, 0};
  glm::dvec3 y{0, 1, 0};
  double scale = 1;

  std::vector<glm::dvec3> place(const Polygon& polygon) const {
    std::vector<glm::dvec3> corners;
    for (const glm::dvec2& point : polygon) corners.push_back((origin + point.x * x + point.y * y) * scale);
    return corners;
  }
};

glm::dvec3 random_direction(std::mt19937_64& random) {
  const glm::dvec3 direction{uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1)};
  return glm::length(direction) > 0.1 ? glm::normalize(direction) : random_direction(random);
}

/// Any orientation and place, about the polygon's size away from the origin.
Placement random_placement(std::mt19937_64& random) {
  Placement placement;
  placement.x = random_direction(random);
  glm::dvec3 across{};
  do {
    across = glm::cross(placement.x, random_direction(random));
  } while (glm::length(across) < 0.1);
  placement.y = glm::normalize(across);
  placement.origin = 2.0 * random_direction(random);
  return placement;
}

double area_in_space(const std::vector<glm::dvec3>& corners, const Triangulation& triangulation, double scale) {
  double sum = 0;
  for (const auto& [i, j, k] : triangulation.triangles) {
    sum += glm::length(glm::cross((corners[j] - corners[i]) / scale, (corners[k] - corners[i]) / scale));
  }
  return sum;
}

std::size_t triangles_over(const Polygon& polygon, const Triangulation& triangulation, const glm::dvec2& point) {
  return static_cast<std::size_t>(
      std::count_if(triangulation.triangles.begin(), triangulation.triangles.end(), [&](const auto& triangle) {
        return encloses({polygon[triangle[0]], polygon[triangle[1]], polygon[triangle[2]]}, point);
      }));
}

/// The polygon's area and coverage are those of its triangles.
void expect_covered(const Polygon& polygon, const Placement& placement, std::mt19937_64& random, int points) {
  const std::vector<glm::dvec3> corners = placement.place(polygon);
  const Triangulation result = triangulate(corners);
  ASSERT_FALSE(result.crossing);
  ASSERT_LE(result.triangles.size(), polygon.size() - 2);
  const double area = std::abs(twice_area(polygon));
  ASSERT_NEAR(area_in_space(corners, result, placement.scale), area, 1e-9 * area);
  glm::dvec2 low = polygon[0];
  glm::dvec2 high = polygon[0];
  for (const glm::dvec2& corner : polygon) {
    low = glm::min(low, corner);
    high = glm::max(high, corner);
  }
  for (int k = 0; k < points; ++k) {
    const glm::dvec2 point{uniform(random, low.x, high.x), uniform(random, low.y, high.y)};
    ASSERT_EQ(triangles_over(polygon, result, point), encloses(polygon, point) ? 1U : 0U) << point.x << ' ' << point.y;
  }
}

/// The same from a few first corners, both ways round, in the axes' planes and in any plane, at its own and at
/// extreme scales.
void expect_covered_however_given(Polygon polygon, std::mt19937_64& random, int points = 20) {
  for (int turn = 0; turn < 3; ++turn) {
    std::rotate(polygon.begin(), polygon.begin() + static_cast<std::ptrdiff_t>(random() % polygon.size()),
                polygon.end());
    if (turn == 1) std::reverse(polygon.begin(), polygon.end());
    Placement flat;
    ASSERT_NO_FATAL_FAILURE(expect_covered(polygon, flat, random, points));
    flat = {{5, 0, 0}, {0, 0, 1}, {0, 1, 0}, turn == 0 ? 0x1p80 : turn == 1 ? 0x1p300 : 0x1p-300};
    ASSERT_NO_FATAL_FAILURE(expect_covered(polygon, flat, random, points));
    Placement tilted = random_placement(random);
    ASSERT_NO_FATAL_FAILURE(expect_covered(polygon, tilted, random, points));
    tilted.scale = turn == 0 ? 0x1p-80 : turn == 1 ? 0x1p-300 : 0x1p300;
    ASSERT_NO_FATAL_FAILURE(expect_covered(polygon, tilted, random, points));
  }
}

void expect_all_covered(int count, const std::function<Polygon(std::mt19937_64&)>& make) {
  std::mt19937_64 random(1);
  for (int k = 0; k < count; ++k) {
    const Polygon polygon = make(random);
    std::string text;
    for (const glm::dvec2& c : polygon) text += std::to_string(c.x) + " " + std::to_string(c.y) + ", ";
    SCOPED_TRACE("polygon " + std::to_string(k) + ": " + text);
    ASSERT_NO_FATAL_FAILURE(expect_covered_however_given(polygon, random));
  }
}

TEST(Triangulate, CoversStarShapedPolygons) {
  expect_all_covered(600, [](auto& random) { return star(random, 4 + random() % 20); });
}

TEST(Triangulate, CoversSimplePolygons) {
  expect_all_covered(300, [](auto& random) { return untangled(random, 4 + random() % 25); });
}

TEST(Triangulate, CoversCombsAndSpirals) {
  expect_all_covered(20, [](auto& random) { return comb(1 + static_cast<int>(random() % 8)); });
  expect_all_covered(20, [](auto& random) { return spiral(300 + random() % 100, uniform(random, 0.5, 3), 0.3); });
  expect_all_covered(5, [](auto& random) { return spiral(200 + random() % 20, 2, 1e-5); });
}

TEST(Triangulate, CoversPolygonsWithBridgedHoles) {
  for (const std::size_t holes : {1, 2, 3, 4}) {
    expect_all_covered(150, [&](auto& random) { return keyhole(random, 8 + random() % 12, holes); });
  }
}

/// `polygon` with corners added on its sides, where they are exactly on them, and some corners twice or three times.
Polygon with_idle_corners(const Polygon& polygon, std::mt19937_64& random) {
  Polygon result;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const glm::dvec2 side = polygon[(k + 1) % polygon.size()] - polygon[k];
    for (std::size_t copies = random() % 4 == 0 ? 3 : 1; copies > 0; --copies) result.push_back(polygon[k]);
    for (std::size_t quarters = 1; quarters < 4; ++quarters) {
      if (random() % 2 == 0) result.push_back(polygon[k] + static_cast<double>(quarters) / 4 * side);
    }
  }
  return result;
}

/// `polygon` on a grid of 2^-20: sums and quarters are exact.
Polygon on_grid(Polygon polygon) {
  for (glm::dvec2& corner : polygon) corner = glm::round(corner * 0x1p20) * 0x1p-20;
  return polygon;
}

TEST(Triangulate, CornersOnSidesAndRepeatedCornersChangeNothing) {
  expect_all_covered(100,
                     [](auto& random) { return with_idle_corners(comb(1 + static_cast<int>(random() % 4)), random); });
  expect_all_covered(200,
                     [](auto& random) { return with_idle_corners(on_grid(star(random, 4 + random() % 12)), random); });
  expect_all_covered(200, [](auto& random) {
    return with_idle_corners(on_grid(keyhole(random, 8 + random() % 5, 1 + random() % 3)), random);
  });
}

TEST(Triangulate, CornersOnSidesMakeNoTriangleWithoutAnArea) {
  std::mt19937_64 random(2);
  for (int k = 0; k < 200; ++k) {
    Polygon polygon;
    for (const glm::dvec2& corner : with_idle_corners(on_grid(star(random, 4 + random() % 12)), random)) {
      if (polygon.empty() || corner != polygon.back()) polygon.push_back(corner);
    }
    EXPECT_EQ(triangulate(Placement().place(polygon)).triangles.size(), polygon.size() - 2);  // so all corners are used
  }
}

TEST(Triangulate, CoversWhatTouchesItselfInAPoint) {
  std::mt19937_64 random(3);
  const Polygon pinched{{0, 0}, {2, 0}, {1, 1}, {2, 2}, {0, 2}, {1, 1}};
  const Polygon corner_on_side{{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}};
  const Polygon islands{{0, 0}, {1, 0}, {1, 1}, {3, 1}, {3, 0}, {4, 0}, {4, 2}, {3, 2}, {3, 1}, {1, 1}, {0, 1}};
  const Polygon bent{{0, 0}, {1, 0}, {2, 1}, {3, 0}, {4, 0}, {4, -2}, {5, -2},
                     {5, 1}, {4, 1}, {3, 0}, {2, 1}, {1, 0}, {1, 1},  {0, 1}};
  const Polygon slit{{0, 0}, {4, 0}, {4, 4}, {2, 4}, {2, 2}, {3, 1}, {2, 2}, {2, 4}, {0, 4}};
  const Polygon spike{{0, 0}, {4, 0}, {4, 4}, {6, 6}, {7, 5}, {6, 6}, {4, 4}, {0, 4}};
  for (const Polygon& polygon : {pinched, corner_on_side, islands, bent, slit, spike}) {
    SCOPED_TRACE(polygon.size());
    ASSERT_NO_FATAL_FAILURE(expect_covered_however_given(polygon, random, 200));
  }
}

TEST(Triangulate, CoversPolygonsBentOutOfTheirPlane) {
  std::mt19937_64 random(4);
  for (int k = 0; k < 300; ++k) {
    const Polygon polygon = star(random, 4 + random() % 8);
    const Placement placement = random_placement(random);
    std::vector<glm::dvec3> corners = placement.place(polygon);
    const glm::dvec3 normal = glm::cross(placement.x, placement.y);
    for (glm::dvec3& corner : corners) corner += uniform(random, -1e-6, 1e-6) * normal;
    const Triangulation result = triangulate(corners);
    ASSERT_FALSE(result.crossing);
    const double area = std::abs(twice_area(polygon));
    ASSERT_NEAR(area_in_space(corners, result, 1), area, 1e-9);
    std::rotate(corners.begin(), corners.begin() + 1, corners.end());
    ASSERT_NEAR(area_in_space(corners, triangulate(corners), 1), area, 1e-9);
  }
}

TEST(Triangulate, NeitherFirstCornerNorDirectionChooseTheTriangles) {
  std::mt19937_64 random(5);
  for (int k = 0; k < 100; ++k) {
    std::vector<glm::dvec3> corners = random_placement(random).place(star(random, 4 + random() % 12));
    const auto triangles = [&] {
      std::vector<std::vector<std::array<double, 3>>> result;
      for (const auto& triangle : triangulate(corners).triangles) {
        result.emplace_back();
        for (const std::uint32_t i : triangle) result.back().push_back({corners[i].x, corners[i].y, corners[i].z});
        std::sort(result.back().begin(), result.back().end());
      }
      std::sort(result.begin(), result.end());
      return result;
    };
    const auto expected = triangles();
    std::rotate(corners.begin(), corners.begin() + 3, corners.end());
    ASSERT_EQ(triangles(), expected);
    std::reverse(corners.begin(), corners.end());
    ASSERT_EQ(triangles(), expected);
  }
}

bool crosses(const Polygon& polygon, const Placement& placement = {}) {
  return triangulate(placement.place(polygon)).crossing;
}

TEST(Triangulate, SaysWhichPolygonsCrossThemselves) {
  Polygon pentagram;
  for (int k = 0; k < 5; ++k)
    pentagram.push_back({std::cos(k * 4 * std::numbers::pi / 5), std::sin(k * 4 * std::numbers::pi / 5)});
  const std::vector<Polygon> crossing{
      {{0, 0}, {1, 1}, {1, 0}, {0, 1}},                                                  // areas that cancel
      {{0, 0}, {3, 1}, {3, 0}, {0, 2}},                                                  // areas that do not
      {{0, 0}, {2, 2}, {4, 4}, {4, 0}, {2, 2}, {0, 4}},                                  // a corner where it crosses
      pentagram,                                                                         // winding number 2
      {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {3, 1}, {3, 3}, {1, 3}, {1, 1}},  // a hole's loop turned round
      {{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 4}, {4, 4}, {4, 8}, {8, 8}, {8, 1}, {1, 1}, {1, 7}, {-1, 7}, {-1, 0}},
      {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {4, 0}, {4, 4}, {0, 4}},  // twice round
  };
  std::mt19937_64 random(6);
  for (Polygon polygon : crossing) {
    SCOPED_TRACE(polygon.size());
    for (int k = 0; k < 10; ++k) {
      std::rotate(polygon.begin(), polygon.begin() + 1, polygon.end());
      EXPECT_TRUE(crosses(polygon));
      EXPECT_TRUE(crosses(polygon, random_placement(random)));
      std::reverse(polygon.begin(), polygon.end());
      EXPECT_TRUE(crosses(polygon));
    }
  }
  int simple = 0;
  for (int k = 0; k < 300; ++k) {
    const Polygon tangled{{uniform(random, 0, 1), uniform(random, 0, 1)},
                          {uniform(random, 0, 1), uniform(random, 0, 1)},
                          {uniform(random, 0, 1), uniform(random, 0, 1)},
                          {uniform(random, 0, 1), uniform(random, 0, 1)},
                          {uniform(random, 0, 1), uniform(random, 0, 1)}};
    bool meets = false;
    for (std::size_t i = 0; i < 5; ++i) {
      meets |= meet(tangled[i], tangled[(i + 1) % 5], tangled[(i + 2) % 5], tangled[(i + 3) % 5]);
    }
    EXPECT_EQ(crosses(tangled), meets);
    simple += meets ? 0 : 1;
  }
  EXPECT_GT(simple, 20);
  EXPECT_LT(simple, 280);
}

TEST(Triangulate, PolygonsWithoutAnAreaHaveNoTriangles) {
  for (const Polygon& polygon : {Polygon{{1, 1}, {1, 1}, {1, 1}, {1, 1}}, Polygon{{0, 0}, {1, 1}, {2, 2}, {3, 3}},
                                 Polygon{{0, 0}, {1, 0}, {1, 1}, {1, 0}}, Polygon{{0, 0}, {0, 0}, {0, 0}, {0, 0}}}) {
    const Triangulation result = triangulate(Placement().place(polygon));
    EXPECT_TRUE(result.triangles.empty());
    EXPECT_FALSE(result.crossing);
  }
}

TEST(Triangulate, TakesTenThousandCorners) {
  std::mt19937_64 random(7);
  ASSERT_NO_FATAL_FAILURE(expect_covered(spiral(10'000, 20, 0.3), random_placement(random), random, 5));
  ASSERT_NO_FATAL_FAILURE(expect_covered(star(random, 10'000), {}, random, 5));
  ASSERT_NO_FATAL_FAILURE(expect_covered(comb(2'499), {}, random, 5));
  Polygon tangle;
  for (int k = 0; k < 3'000; ++k) tangle.push_back({uniform(random, -1, 1), uniform(random, -1, 1)});
  EXPECT_TRUE(crosses(tangle));
}

}  // namespace
}  // namespace pyrasim
