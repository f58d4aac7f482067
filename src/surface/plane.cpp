// SPDX-License-Identifier: Apache-2.0
#include "surface/plane.h"

#include <cmath>

#include "numeric/vectors.h"
#include "surface/affine_map.h"
#include "surface/pov_writer.h"

namespace pyrasim {
namespace {

/// The offset is worked out exactly from numbers that were read.
BoundingPlane bounding_plane(const PlaneSurface<double>& plane, const RoundingUnits& rounding) {
  const double written = 3 * rounding.written(0) * largest(plane.normal) + 0x1p-52 * std::abs(plane.offset);
  return {plane.normal, plane.offset, written};
}

}  // namespace

Plane Plane::read(const JsonReader& reader, const SceneReading&) {
  return {read_direction(reader.member("normal")), reader.member("offset").number(coordinates)};
}

Prepared<PlaneSurface> prepared_plane(const glm::dvec3& normal, Quadruple offset, const Preparation& preparation) {
  const Scaling scaling{-std::ilogb(largest(normal))};
  auto shading = flat_shading(preparation.frame.direction(normalized(normal)), preparation.lighting);
  shading.normal = preparation.frame.direction(scaling(normal, 1));
  return {{shading.normal, scaling(static_cast<double>(offset), 1)}, shading};
}

/// The offset from the observer's place cancels where that is near the plane and far from the world's origin; it is
/// worked out exactly and rounded once.
Prepared<PlaneSurface> Plane::prepared(const Preparation& preparation) const {
  Quadruple from_observer = offset;
  for (int axis = 0; axis < 3; ++axis) {
    from_observer -= static_cast<Quadruple>(normal[axis]) * preparation.frame.position()[axis];
  }
  return prepared_plane(normal, from_observer, preparation);
}

/// Its normal keeps a length about 1.
Plane Plane::transformed(const AffineMap& map) const {
  const QuadrupleVector mapped = map.normal(exactly(normal));
  const Quadruple scale = 1 / pyrasim::length(mapped);
  const glm::dvec3 direction = rounded(unit(mapped));
  const auto away = static_cast<double>((offset + dot(mapped, map.offset())) * scale);
  return {direction, away == 0 ? 0 : std::copysign(mapped_length(std::abs(away)), away)};
}

void Plane::write_pov(PovWriter& pov) const { pov.plane(normal, offset); }

double reach(const PlaneSurface<double>& plane) { return std::abs(plane.offset); }

std::optional<BoundingBox> bounds(const PlaneSurface<double>&) { return std::nullopt; }

/// It has none.
std::optional<BoundingBox> slope_bounds(const PlaneSurface<double>&, double) { return std::nullopt; }

PlaneError relative_error(const PlaneSurface<double>& plane, const RoundingUnits& rounding) {
  return plane_error(bounding_plane(plane, rounding), rounding);
}

DistanceRange distance_range(const PlaneSurface<double>& plane, const Vector<double>& direction, double t,
                             const RoundingUnits& rounding) {
  const DistanceRange range = plane_distance_range(bounding_plane(plane, rounding), direction, rounding);
  return {std::min(t, range.lowest), std::max(t, range.highest)};
}

/// From the point nearest to the origin on.
SurfaceCoordinates Plane::coordinates_at(const glm::dvec3& point) const {
  return on_plane(normal, glm::dvec3(0), point);
}

}  // namespace pyrasim
