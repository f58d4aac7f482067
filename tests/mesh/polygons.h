// SPDX-License-Identifier: Apache-2.0
// Polygons of the plane to triangulate, and what they enclose.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numbers>
#include <random>
#include <vector>

namespace pyrasim {

using Polygon = std::vector<glm::dvec2>;

inline double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

/// Twice the area, positive where the polygon runs counterclockwise.
inline double twice_area(const Polygon& polygon) {
  long double sum = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const glm::dvec2 a = polygon[k] - polygon[0];
    const glm::dvec2 b = polygon[(k + 1) % polygon.size()] - polygon[0];
    sum += static_cast<long double>(a.x) * b.y - static_cast<long double>(a.y) * b.x;
  }
  return static_cast<double>(sum);
}

/// Whether a ray from `point` meets the sides an odd number of times.
inline bool encloses(const Polygon& polygon, const glm::dvec2& point) {
  bool inside = false;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const glm::dvec2 a = polygon[k];
    const glm::dvec2 b = polygon[(k + 1) % polygon.size()];
    if ((a.y > point.y) != (b.y > point.y) && point.x < a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x)) {
      inside = !inside;
    }
  }
  return inside;
}

inline double distance(const glm::dvec2& point, const glm::dvec2& a, const glm::dvec2& b) {
  const glm::dvec2 side = b - a;
  const double length = glm::dot(side, side);
  const double share = length > 0 ? std::clamp(glm::dot(point - a, side) / length, 0.0, 1.0) : 0;
  return glm::length(point - a - share * side);
}

/// Whether two sides that share no corner meet.
inline bool meet(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d) {
  return (cross(b - a, c - a) > 0) != (cross(b - a, d - a) > 0) &&
         (cross(d - c, a - c) > 0) != (cross(d - c, b - c) > 0);
}

inline double uniform(std::mt19937_64& random, double from, double to) {
  return std::uniform_real_distribution<double>(from, to)(random);
}

/// Star-shaped: seen whole from the origin, within the unit circle.
inline Polygon star(std::mt19937_64& random, std::size_t corners) {
  Polygon polygon;
  for (std::size_t k = 0; k < corners; ++k) {
    const double angle = 2 * std::numbers::pi * (static_cast<double>(k) + uniform(random, 0, 0.9)) / corners;
    polygon.push_back(uniform(random, 0.1, 1) * glm::dvec2(std::cos(angle), std::sin(angle)));
  }
  return polygon;
}

/// Random points, joined in an order without crossings: two sides that cross are replaced by two that do not.
inline Polygon untangled(std::mt19937_64& random, std::size_t corners) {
  Polygon polygon;
  for (std::size_t k = 0; k < corners; ++k) polygon.push_back({uniform(random, -1, 1), uniform(random, -1, 1)});
  for (bool crossed = true; crossed;) {
    crossed = false;
    for (std::size_t i = 0; i + 2 < corners; ++i) {
      for (std::size_t j = i + 2; j < corners; ++j) {
        if (i == 0 && j + 1 == corners) continue;
        if (!meet(polygon[i], polygon[i + 1], polygon[j], polygon[(j + 1) % corners])) continue;
        std::reverse(polygon.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                     polygon.begin() + static_cast<std::ptrdiff_t>(j) + 1);
        crossed = true;
      }
    }
  }
  return polygon;
}

/// On a grid of integers, so that corners lie exactly on common lines.
inline Polygon comb(int teeth) {
  Polygon polygon{{0, -1}, {3.0 * teeth, -1}};
  for (int k = teeth - 1; k >= 0; --k) {
    polygon.insert(polygon.end(), {{3.0 * k + 2, 0}, {3.0 * k + 2, 9}, {3.0 * k + 1, 9}, {3.0 * k + 1, 0}});
  }
  return polygon;
}

/// Two arms wound around each other; `width`: of the band, where a turn is 1.
inline Polygon spiral(std::size_t corners, double turns, double width) {
  Polygon polygon;
  const std::size_t half = corners / 2;
  for (std::size_t k = 0; k < 2 * half; ++k) {
    const double step = static_cast<double>(k < half ? k : 2 * half - 1 - k) / static_cast<double>(half);
    const double angle = 2 * std::numbers::pi * turns * step;
    const double radius = 1 + turns * step + (k < half ? 0 : width);
    polygon.push_back(radius * glm::dvec2(std::cos(angle), std::sin(angle)));
  }
  return polygon;
}

/// Whether the way from a corner towards `point` begins inside a counterclockwise polygon.
inline bool begins_inside(const Polygon& polygon, std::size_t corner, const glm::dvec2& point) {
  const glm::dvec2& at = polygon[corner];
  const glm::dvec2 next = polygon[(corner + 1) % polygon.size()] - at;
  const glm::dvec2 previous = polygon[(corner + polygon.size() - 1) % polygon.size()] - at;
  const bool after_next = cross(next, point - at) > 0;
  const bool before_previous = cross(point - at, previous) > 0;
  return cross(next, previous) > 0 ? after_next && before_previous : after_next || before_previous;
}

/// Joins `hole` to the ring by the shortest bridge that meets no side of the ring and of the other loops.
inline void bridge(Polygon& ring, const Polygon& hole, const std::vector<Polygon>& others) {
  std::vector<Polygon> loops = others;
  loops.push_back(ring);
  loops.push_back(hole);
  const auto is_free = [&](const glm::dvec2& a, const glm::dvec2& b) {
    for (const Polygon& loop : loops) {
      for (std::size_t k = 0; k < loop.size(); ++k) {
        const glm::dvec2& c = loop[k];
        const glm::dvec2& d = loop[(k + 1) % loop.size()];
        if (a != c && a != d && b != c && b != d && meet(a, b, c, d)) return false;
      }
    }
    return true;
  };
  double shortest = 1e300;
  std::size_t from = 0;
  std::size_t to = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    for (std::size_t j = 0; j < hole.size(); ++j) {
      const double length = glm::length(ring[i] - hole[j]);
      if (length >= shortest || !begins_inside(ring, i, hole[j]) || !is_free(ring[i], hole[j])) continue;
      shortest = length;
      from = i;
      to = j;
    }
  }
  Polygon detour;
  for (std::size_t k = 0; k <= hole.size(); ++k) detour.push_back(hole[(to + k) % hole.size()]);
  detour.push_back(ring[from]);
  ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(from) + 1, detour.begin(), detour.end());
}

/// A ring of `corners` with up to four star-shaped holes, each joined by a bridge that is walked there and back.
inline Polygon keyhole(std::mt19937_64& random, std::size_t corners, std::size_t holes) {
  Polygon ring = star(random, corners);
  for (glm::dvec2& corner : ring) corner *= uniform(random, 1, 2) / glm::length(corner);
  std::vector<Polygon> loops;
  for (std::size_t k = 0; k < holes; ++k) {
    loops.push_back(star(random, 4 + random() % 6));
    std::reverse(loops.back().begin(), loops.back().end());
    const glm::dvec2 center{k % 2 == 0 ? -0.3 : 0.3, k < 2 ? -0.3 : 0.3};
    for (glm::dvec2& corner : loops.back()) corner = center + 0.25 * corner;
  }
  while (!loops.empty()) {
    const Polygon hole = loops.back();
    loops.pop_back();
    bridge(ring, hole, loops);
  }
  return ring;
}

}  // namespace pyrasim
