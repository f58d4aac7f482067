// SPDX-License-Identifier: Apache-2.0
#include "mesh/orientation.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "mesh/exact_sum.h"

namespace pyrasim {
namespace {

constexpr int largest_exponent = 400;
constexpr int grid_exponent = -537;  ///< products of two multiples of 2^-537 are multiples of the smallest double

/// value * 2^exponent, rounded to the grid.
double scaled(double value, int exponent) {
  const double result = std::ldexp(value, exponent);
  constexpr int exact_above = grid_exponent + std::numeric_limits<double>::digits;
  if (std::abs(result) >= std::ldexp(1.0, exact_above)) return result;
  return std::ldexp(std::nearbyint(std::ldexp(result, -grid_exponent)), grid_exponent);
}

/// The axis that the polygon's plane faces most. The magnitudes of the triangles between the centre and the sides are
/// added up: in a plane all of them face alike, and loops of opposite direction do not cancel.
int facing_axis(const std::vector<glm::dvec3>& corners) {
  glm::dvec3 center{0, 0, 0};
  for (const glm::dvec3& corner : corners) center += corner / static_cast<double>(corners.size());
  glm::dvec3 areas{0, 0, 0};
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const glm::dvec3& next = corners[k + 1 < corners.size() ? k + 1 : 0];
    areas += glm::abs(glm::cross(corners[k] - center, next - center));
  }
  if (areas.x >= areas.y && areas.x >= areas.z) return 0;
  return areas.y >= areas.z ? 1 : 2;
}

}  // namespace

PlanePoints project(std::span<const glm::dvec3> corners) {
  double largest = 0;
  for (const glm::dvec3& corner : corners) {
    largest = std::max({largest, std::abs(corner.x), std::abs(corner.y), std::abs(corner.z)});
  }
  int exponent = 0;
  std::frexp(largest, &exponent);
  std::vector<glm::dvec3> points;
  points.reserve(corners.size());
  for (const glm::dvec3& corner : corners) {
    const int up = largest_exponent - exponent;
    points.emplace_back(scaled(corner.x, up), scaled(corner.y, up), scaled(corner.z, up));
  }
  const int axis = facing_axis(points);
  PlanePoints projected;
  projected.reserve(points.size());
  for (const glm::dvec3& point : points) projected.emplace_back(point[(axis + 1) % 3], point[(axis + 2) % 3]);
  return projected;
}

int orientation(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  const double left = (a.x - c.x) * (b.y - c.y);
  const double right = (a.y - c.y) * (b.x - c.x);
  const double difference = left - right;
  // Shewchuk's bound for this order of operations; where both products are 0, they are so exactly.
  constexpr double unit = std::numeric_limits<double>::epsilon() / 2;
  constexpr double bound = (3 + 16 * unit) * unit;
  if (std::abs(difference) >= bound * (std::abs(left) + std::abs(right))) return (difference > 0) - (difference < 0);
  ExactSum area;
  area.add_product(a.x, b.y);
  area.add_product(-a.y, b.x);
  area.add_product(b.x, c.y);
  area.add_product(-b.y, c.x);
  area.add_product(c.x, a.y);
  area.add_product(-c.y, a.x);
  return area.sign();
}

int winding(const PlanePoints& corners) {
  ExactSum area;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const glm::dvec2& next = corners[k + 1 < corners.size() ? k + 1 : 0];
    area.add_product(corners[k].x, next.y);
    area.add_product(-corners[k].y, next.x);
  }
  return area.sign();
}

}  // namespace pyrasim
