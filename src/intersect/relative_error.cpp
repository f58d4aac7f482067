// SPDX-License-Identifier: Apache-2.0
// Letters as in distance_range.cpp; lengths are along a view vector of length 1.
#include "intersect/relative_error.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pyrasim {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// What a coarser bound would tell apart, the finer one has to look at in any case. In fixed point errors are absolute.
double if_of_use(double error, const RoundingUnits& rounding) {
  constexpr double of_use = 0x1p-8;
  return rounding.relative > 0 && error < of_use ? error : infinity;
}

double largest(const Vector<double>& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

}  // namespace

/// The product of the two roots is |power|, so that the outer one, by which t's quotient errs, is at least its root.
/// The half chord errs most, by the root of the discriminant's error, where the ray grazes the sphere.
double relative_error(const SphereSurface<double>& surface, const RoundingUnits& rounding) {
  const double u = rounding.relative;
  const double a = rounding.absolute;
  const double away = std::sqrt(dot(surface.center, surface.center));
  const double reach = away + surface.radius;
  const double written = rounding.written(reach);
  const double power = std::abs(surface.power);
  const double center = 16 * u * away + 4 * written + 16 * a;
  const double discriminant = 2 * surface.radius * (20 * u * reach + 6 * written) + center * center + 16 * a;
  const double power_error = (4 * reach * written + a) / power;
  return if_of_use(2 * ((center + std::sqrt(discriminant)) / std::sqrt(power) + power_error + 16 * u), rounding);
}

/// t is N . a / N . d with N the normal, twice the area long. The product of t and the determinant is the same for all
/// rays; and no hit is nearer than the triangle's plane.
double relative_error(const TriangleSurface<double>& surface, const RoundingUnits& rounding) {
  const double u = rounding.relative;
  const double a = rounding.absolute;
  const auto vertex = [&](std::size_t k) {
    const auto& [x, y, z] = surface.vertices[k];
    return Vector<double>(x, y, z);
  };
  const auto side = vertex(1) - vertex(0);
  const auto other_side = vertex(2) - vertex(0);
  const auto normal = cross(side, other_side);
  const double size = std::max({largest(vertex(0)), largest(vertex(1)), largest(vertex(2))});
  const double extent = 2 * std::max(largest(side), largest(other_side));  // of the triangle, whichever its sides
  const double written = rounding.written(size);
  // Of a sheared vertex, whose size is twice the extent at most; and of the three edge functions.
  const double moved_error = 8 * u * size + 2 * written + 4 * a;
  const double edges_error =
      3 * (8 * extent * moved_error + 2 * moved_error * moved_error + 16 * u * extent * extent + 4 * a);
  const double volume = std::abs(dot(normal, vertex(0))) - 16 * 0x1p-53 * extent * extent * size;
  const double left = volume - edges_error * size;
  if (!(left > 0)) return infinity;
  const double nearest = volume / (2 * std::sqrt(dot(normal, normal)));
  const double own = 12 * u * size + written + 4 * a;
  return if_of_use(2 * ((extent * edges_error + 8 * a) / left + own / nearest), rounding);
}

PlaneError relative_error(const PlaneSurface<double>& surface, const RoundingUnits& rounding) {
  const double u = rounding.relative;
  const double a = rounding.absolute;
  const double size = largest(surface.shading.normal);
  const double offset = std::abs(surface.offset);
  const double own = 4 * u + (a + 3 * rounding.written(0) * size) / offset;
  const double relative = if_of_use(4 * std::max(own, std::sqrt(u)), rounding);
  // n . d errs by so much of the length of d.
  const double approach_error = 3 * (2 * u + 22 * 0x1p-53) * size + 8 * a;
  const double length = offset * relative / (8 * approach_error);
  return {relative, std::isfinite(relative) ? length * length : 0};
}

}  // namespace pyrasim
