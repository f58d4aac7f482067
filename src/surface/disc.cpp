// SPDX-License-Identifier: Apache-2.0
#include "surface/disc.h"

#include <cmath>
#include <numbers>

#include "numeric/quadruple.h"
#include "numeric/vectors.h"
#include "surface/affine_map.h"
#include "surface/error_bounds.h"
#include "surface/plane.h"
#include "surface/pov_writer.h"
#include "surface/slope_bounds.h"

namespace pyrasim {
namespace {

/// What the scene says of the plane: the normal's decimal numbers, and the centre's, which lies within reach.
BoundingPlane bounding_plane(const DiscSurface<double>& disc, const RoundingUnits& rounding) {
  return {disc.normal, disc.offset, 3 * largest(disc.normal) * rounding.written(reach(disc))};
}

double radius_of(const DiscSurface<double>& disc) { return std::sqrt(disc.radius_squared); }

/// By how much the disc reaches beyond its centre along x.
double depth_of(const DiscSurface<double>& disc) {
  const double squared = dot(disc.normal, disc.normal);
  const double across = std::max(0.0, 1 - disc.normal.x * disc.normal.x / squared);
  return radius_of(disc) * std::sqrt(across);
}

/// The regular octagon about the disc.
std::array<glm::dvec3, 8> octagon_about(const DiscSurface<double>& disc) {
  constexpr std::size_t corners = 8;
  const auto normal = normalized(disc.normal);
  int least = 0;
  for (int axis = 1; axis < 3; ++axis) {
    if (std::abs(normal[axis]) <= std::abs(normal[least])) least = axis;
  }
  glm::dvec3 away(0);
  away[least] = 1;
  const auto along = normalized(cross(normal, away));
  const auto across = cross(normal, along);
  const double corner = radius_of(disc) / std::cos(std::numbers::pi / corners) * (1 + 0x1p-40);
  std::array<glm::dvec3, corners> points;
  for (std::size_t k = 0; k < corners; ++k) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(k) / corners;
    points[k] = disc.center + along * (corner * std::cos(angle)) + across * (corner * std::sin(angle));
  }
  return points;
}

}  // namespace

Disc Disc::read(const JsonReader& reader, const SceneReading&) {
  return {reader.member("center").vec3(coordinates), read_direction(reader.member("normal")),
          reader.member("radius").number(lengths)};
}

/// The plane through the centre, its offset from the observer exact and rounded once.
Prepared<DiscSurface> Disc::prepared(const Preparation& preparation) const {
  Quadruple offset = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const Quadruple away = static_cast<Quadruple>(center[axis]) - preparation.frame.position()[axis];
    offset += static_cast<Quadruple>(normal[axis]) * away;
  }
  const auto [plane, shading] = prepared_plane(normal, offset, preparation);
  return {{plane.normal, plane.offset, preparation.frame.point(center), radius * radius}, shading};
}

Disc Disc::transformed(const AffineMap& map) const {
  const Quadruple factor = required_similarity(map, "disc", "an ellipse");
  return {mapped_point(map, center), rounded(unit(map.normal(exactly(normal)))), mapped_length(factor * radius)};
}

void Disc::write_pov(PovWriter& pov) const { pov.object("disc", center, normalized(normal), radius); }

double reach(const DiscSurface<double>& disc) {
  return std::max(largest(disc.center) + radius_of(disc), std::abs(disc.offset));
}

std::optional<BoundingBox> bounds(const DiscSurface<double>& disc) { return box_of(octagon_about(disc)); }

std::optional<BoundingBox> slope_bounds(const DiscSurface<double>& disc, double margin) {
  return slope_bounds_of_hull(octagon_about(disc), margin);
}

/// No ray meets it further away than its rim is.
double relative_error(const DiscSurface<double>& disc, const RoundingUnits& rounding) {
  const double furthest = length(disc.center) + radius_of(disc);
  return plane_error(bounding_plane(disc, rounding), rounding).within(furthest);
}

DistanceRange distance_range(const DiscSurface<double>& disc, const Vector<double>& direction, double t,
                             const RoundingUnits& rounding) {
  const double size = reach(disc);
  const double margin = 4 * rounding.relative * size + 2 * rounding.absolute + rounding.written(size);
  const double depth = depth_of(disc) * (1 + 0x1p-40) + margin;
  const DistanceRange plane = plane_distance_range(bounding_plane(disc, rounding), direction, rounding);
  return within_bounds({std::min(t, plane.lowest), std::max(t, plane.highest)}, disc.center.x - depth,
                       disc.center.x + depth, direction);
}

SurfaceCoordinates Disc::coordinates_at(const glm::dvec3& point) const { return on_plane(normal, center, point); }

}  // namespace pyrasim
