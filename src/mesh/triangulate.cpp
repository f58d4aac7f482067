// SPDX-License-Identifier: Apache-2.0
#include "mesh/triangulate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

#include "mesh/ear_clipping.h"
#include "mesh/orientation.h"
#include "text/counted.h"

namespace pyrasim {
namespace {

/// Sides that reach over each other by this share of the polygon's size do so by the rounding of coordinates.
constexpr double slack_share = 0x1p-40;
/// The share of the area that may be wrong before the polygon is said to cross itself.
constexpr double area_share = 1e-9;

struct FlatTriangle {
  std::array<glm::dvec2, 3> corners;
  glm::dvec2 low;
  glm::dvec2 high;
};

std::vector<FlatTriangle> flat_triangles(const PlanePoints& corners, const EarClipping& clipping) {
  std::vector<FlatTriangle> triangles;
  triangles.reserve(clipping.triangles().size());
  for (const auto& [i, j, k] : clipping.triangles()) {
    const glm::dvec2& a = corners[i];
    const glm::dvec2& b = corners[j];
    const glm::dvec2& c = corners[k];
    triangles.push_back({{a, b, c}, glm::min(glm::min(a, b), c), glm::max(glm::max(a, b), c)});
  }
  return triangles;
}

/// Whether one side of `a` has all of `b` on its other side, or within the slack.
bool separates(const FlatTriangle& a, const FlatTriangle& b, double slack) {
  for (std::size_t k = 0; k < 3; ++k) {
    const glm::dvec2 from = a.corners[k];
    const glm::dvec2 side = a.corners[(k + 1) % 3] - from;
    const double reach = slack * glm::length(side);
    if (std::all_of(b.corners.begin(), b.corners.end(), [&](const glm::dvec2& point) {
          return side.x * (point.y - from.y) - side.y * (point.x - from.x) <= reach;
        })) {
      return true;
    }
  }
  return false;
}

/// Whether two of the triangles, which all turn left, have more than the slack in common.
bool overlap(std::vector<FlatTriangle> triangles, double slack) {
  std::sort(triangles.begin(), triangles.end(),
            [](const FlatTriangle& a, const FlatTriangle& b) { return a.low.x < b.low.x; });
  for (auto a = triangles.begin(); a != triangles.end(); ++a) {
    for (auto b = a + 1; b != triangles.end() && b->low.x < a->high.x; ++b) {
      const bool near = a->low.y < b->high.y && b->low.y < a->high.y;
      if (near && !separates(*a, *b, slack) && !separates(*b, *a, slack)) return true;
    }
  }
  return false;
}

double size_of(const PlanePoints& corners) {
  glm::dvec2 low = corners.front();
  glm::dvec2 high = low;
  for (const glm::dvec2& corner : corners) {
    low = glm::min(low, corner);
    high = glm::max(high, corner);
  }
  return std::max(high.x - low.x, high.y - low.y);
}

}  // namespace

Triangulation triangulate(std::span<const glm::dvec3> corners) {
  PlanePoints points = project(corners);
  const bool turns_right = winding(points) < 0;
  if (turns_right) std::reverse(points.begin(), points.end());
  const double slack = slack_share * size_of(points);
  const EarClipping clipping(points, slack);
  Triangulation result;
  result.triangles = clipping.triangles();
  result.crossing = clipping.reversed_share() > area_share || overlap(flat_triangles(points, clipping), slack);
  if (turns_right) {
    const auto last = static_cast<std::uint32_t>(corners.size() - 1);
    for (auto& [i, j, k] : result.triangles) {
      i = last - i;
      j = last - j;
      k = last - k;
      std::swap(i, k);
    }
  }
  return result;
}

std::string crossing_warning(std::size_t polygons, std::size_t first_line) {
  return fmt::format("{}, {} in line {}; what {} is not defined, and any triangles may be seen",
                     polygons == 1 ? "1 polygon crosses or covers itself"
                                   : fmt::format("{} polygons cross or cover themselves", polygons),
                     of_number(polygons, "it is", "the first"), first_line,
                     of_number(polygons, "it encloses", "they enclose"));
}

}  // namespace pyrasim
