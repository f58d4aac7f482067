// SPDX-License-Identifier: Apache-2.0
#include "surface/slope_bounds.h"

namespace pyrasim {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The largest slope y / x of a circle's points with x > 0: that of the tangent from the origin. Its two forms are
/// equal (their quotient is Vieta's), and each is used where its sums do not cancel.
double largest_slope(double x, double y, double radius) {
  const double beyond = (x - radius) * (x + radius);
  const double tangent_squared = beyond + y * y;
  const bool below_at_zero = y < 0 && tangent_squared > 0;  // where the circle meets x = 0, if it does
  if (!(x > radius || below_at_zero)) return infinity;
  const double root = radius * std::sqrt(tangent_squared);
  return x > 0 && y < 0 ? (y - radius) * (y + radius) / (x * y - root) : (x * y + root) / beyond;
}

/// The largest slope y / x in a rectangle, x > 0; `y` is its upper side.
double largest_slope_in_box(double nearest_x, double furthest_x, double y) {
  if (y < 0) return y / furthest_x;
  return nearest_x > 0 ? y / nearest_x : infinity;
}

BoundingBox slope_bounds_of_box(const BoundingBox& box) {
  BoundingBox seen;
  if (!(box.upper.x > 0)) return seen;
  seen.lower.x = box.lower.x;
  seen.upper.x = box.upper.x;
  for (int axis = 1; axis < 3; ++axis) {
    seen.lower[axis] = -largest_slope_in_box(box.lower.x, box.upper.x, -box.lower[axis]);
    seen.upper[axis] = largest_slope_in_box(box.lower.x, box.upper.x, box.upper[axis]);
  }
  return seen;
}

}  // namespace

BoundingBox slope_bounds_of_sphere(const glm::dvec3& center, double radius, double margin) {
  const double grown = radius + margin;
  BoundingBox seen;
  if (!(center.x + grown > 0)) return seen;
  seen.lower.x = center.x - grown;
  seen.upper.x = center.x + grown;
  for (int axis = 1; axis < 3; ++axis) {
    seen.lower[axis] = -largest_slope(center.x, -center[axis], grown);
    seen.upper[axis] = largest_slope(center.x, center[axis], grown);
  }
  return seen;
}

BoundingBox slope_bounds_of_hull(std::span<const glm::dvec3> points, double margin) {
  BoundingBox whole;
  BoundingBox seen;
  for (const glm::dvec3& point : points) {
    const BoundingBox corner{point - margin, point + margin};
    whole.include(corner);
    seen.include(slope_bounds_of_box(corner));
  }
  // Slopes over a hull are largest at one of its points unless it reaches the plane x = 0, where they have no bound.
  return whole.lower.x > 0 ? seen : slope_bounds_of_box(whole);
}

BoundingBox on_screen(const BoundingBox& seen, const Screen& screen) {
  const glm::dvec3 half{0, screen.rows * screen.dy / (2 * screen.dx), screen.columns * screen.dz / (2 * screen.dx)};
  BoundingBox box = seen;
  if (!(seen.lower.x <= seen.upper.x)) box.lower.x = box.upper.x = 0;
  for (int axis = 1; axis < 3; ++axis) {
    box.lower[axis] = std::clamp(seen.lower[axis], -half[axis], half[axis]);
    box.upper[axis] = std::max(box.lower[axis], std::min(seen.upper[axis], half[axis]));
  }
  return box;
}

}  // namespace pyrasim
