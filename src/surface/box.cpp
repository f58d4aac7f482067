// SPDX-License-Identifier: Apache-2.0
#include "surface/box.h"

#include <cmath>
#include <limits>

#include "numeric/vectors.h"
#include "surface/error_bounds.h"
#include "surface/parallelepiped.h"
#include "surface/plane_distance.h"
#include "surface/pov_writer.h"
#include "surface/slope_bounds.h"

namespace pyrasim {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The corners: where three planes meet, by the cross products of the other two's normals.
std::array<glm::dvec3, 8> corners_of(const BoxSurface<double>& box) {
  const auto& [a, b, c] = box.slabs;
  const glm::dvec3 along_a = cross(b.normal, c.normal);
  const glm::dvec3 along_b = cross(c.normal, a.normal);
  const glm::dvec3 along_c = cross(a.normal, b.normal);
  const double volume = dot(a.normal, along_a);
  std::array<glm::dvec3, 8> corners;
  for (std::size_t k = 0; k < 8; ++k) {
    corners[k] = (along_a * (k % 2 == 0 ? a.lower : a.upper) + along_b * (k / 2 % 2 == 0 ? b.lower : b.upper) +
                  along_c * (k / 4 == 0 ? c.lower : c.upper)) /
                 volume;
  }
  return corners;
}

/// The planes of a slab's faces: normals are axes, or known to a rounding, and offsets are read, less the observer's
/// place.
BoundingPlane face(const Slab<double>& slab, double offset, double size, const RoundingUnits& rounding) {
  return {slab.normal, offset, 3 * largest(slab.normal) * rounding.written(size)};
}

/// In which ranges the exact ray enters a slab and leaves it.
struct PassageRange {
  DistanceRange enter{-infinity, infinity};
  DistanceRange leave{-infinity, infinity};
};
PassageRange passage_range(const Slab<double>& slab, double size, const Vector<double>& direction,
                           const RoundingUnits& rounding) {
  const BoundingPlane lower = face(slab, slab.lower, size, rounding);
  const BoundingPlane upper = face(slab, slab.upper, size, rounding);
  const DistanceRange away_lower = plane_distance_range(lower, direction, rounding);
  const DistanceRange away_upper = plane_distance_range(upper, direction, rounding);
  if (away_lower.highest == infinity && certain_side(lower, rounding) && certain_side(upper, rounding)) {
    // Nearly parallel: which way it runs through the slab is not known, but the observer is inside, or outside of it.
    const double nearer = std::min(away_lower.lowest, away_upper.lowest);
    if (slab.lower < 0 && slab.upper > 0) return {{-infinity, -nearer}, {nearer, infinity}};
    return {{nearer, infinity}, {nearer, infinity}};
  }
  const DistanceRange to_lower = signed_plane_distance_range(lower, direction, rounding);
  const DistanceRange to_upper = signed_plane_distance_range(upper, direction, rounding);
  return {{std::min(to_lower.lowest, to_upper.lowest), std::min(to_lower.highest, to_upper.highest)},
          {std::max(to_lower.lowest, to_upper.lowest), std::max(to_lower.highest, to_upper.highest)}};
}

}  // namespace

Box Box::read(const JsonReader& reader, const SceneReading&) {
  const Box box{reader.member("min").vec3(coordinates), reader.member("max").vec3(coordinates)};
  for (int axis = 0; axis < 3; ++axis) {
    if (!(box.max[axis] - box.min[axis] >= min_length)) {
      reader.member("max").fail("the box has no volume", "each component has to be larger than that of min");
    }
  }
  return box;
}

/// Offsets from the observer's place are exact but for one rounding.
Prepared<BoxSurface> Box::prepared(const Preparation& preparation) const {
  Prepared<BoxSurface> prepared;
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 normal(0);
    normal[axis] = 1;
    normal = preparation.frame.direction(normal);
    const double place = preparation.frame.position()[axis];
    const auto k = static_cast<std::size_t>(axis);
    prepared.surface.slabs[k] = {normal, min[axis] - place, max[axis] - place};
    prepared.shading.faces[k] = flat_shading(normal, preparation.lighting);
  }
  return prepared;
}

std::variant<Box, Parallelepiped> Box::transformed(const AffineMap& map) const {
  if (!map.keeps_axes()) {
    const glm::dvec3 size = max - min;
    return Parallelepiped{exactly(min), {{{size.x, 0, 0}, {0, size.y, 0}, {0, 0, size.z}}}}.transformed(map);
  }
  const BoundingBox box = box_of(std::array{mapped_point(map, min), mapped_point(map, max)});
  for (int axis = 0; axis < 3; ++axis) static_cast<void>(mapped_length(box.upper[axis] - box.lower[axis]));
  return Box{box.lower, box.upper};
}

void Box::write_pov(PovWriter& pov) const { pov.object("box", min, max); }

double reach(const BoxSurface<double>& box) {
  double reach = box_of(corners_of(box)).reach();
  for (const auto& slab : box.slabs) reach = std::max({reach, std::abs(slab.lower), std::abs(slab.upper)});
  return reach;
}

std::optional<BoundingBox> bounds(const BoxSurface<double>& box) { return box_of(corners_of(box)); }

std::optional<BoundingBox> slope_bounds(const BoxSurface<double>& box, double margin) {
  return slope_bounds_of_hull(corners_of(box), margin);
}

/// That of the worst of its faces, none of which a ray meets further away than the furthest corner.
double relative_error(const BoxSurface<double>& box, const RoundingUnits& rounding) {
  const double size = reach(box);
  const double furthest = 2 * size;  // of a corner: at most the root of 3 times as far
  double error = 0;
  for (const auto& slab : box.slabs) {
    for (const double offset : {slab.lower, slab.upper}) {
      error = std::max(error, plane_error(face(slab, offset, size, rounding), rounding).within(furthest));
    }
  }
  return error;
}

/// A ray enters at the last of the slabs' entrances, and leaves at the first of their exits. Where it cannot be told
/// whether the observer is inside, the hit may be the one or the other.
DistanceRange distance_range(const BoxSurface<double>& box, const Vector<double>& direction, double t,
                             const RoundingUnits& rounding) {
  const BoundingBox all = box_of(corners_of(box));
  const double size = all.reach();
  DistanceRange enter{-infinity, -infinity};
  DistanceRange leave{infinity, infinity};
  for (const auto& slab : box.slabs) {
    const PassageRange passage = passage_range(slab, size, direction, rounding);
    enter = later(enter, passage.enter);
    leave = earlier(leave, passage.leave);
  }
  const bool may_enter = enter.highest > 0;
  const bool may_be_inside = !(enter.lowest > 0);
  const DistanceRange hit{std::max(0.0, may_enter ? enter.lowest : leave.lowest),
                          may_be_inside ? leave.highest : enter.highest};
  const double margin = 4 * rounding.relative * size + 2 * rounding.absolute + rounding.written(size);
  return within_bounds({std::min(t, hit.lowest), std::max(t, hit.highest)}, all.lower.x - margin, all.upper.x + margin,
                       direction);
}

/// A chart for each face, of the two axes along it: z and y, x and z, x and y; from the lower corner on. A point lies
/// on the face that it is nearest to.
SurfaceCoordinates Box::coordinates_at(const glm::dvec3& point) const {
  int face = 0;
  double nearest = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    for (const int side : {0, 1}) {
      const double away = std::abs(point[axis] - (side == 0 ? min : max)[axis]);
      if (away < nearest) {
        nearest = away;
        face = 2 * axis + side;
      }
    }
  }
  const glm::dvec3 from = point - min;
  switch (face / 2) {
    case 0:
      return {.u = from.z, .v = from.y, .chart = face};
    case 1:
      return {.u = from.x, .v = from.z, .chart = face};
    default:
      return {.u = from.x, .v = from.y, .chart = face};
  }
}

}  // namespace pyrasim
