// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <limits>

#include "numeric/compensated.h"
#include "numeric/quadruple.h"
#include "surface/bounding_box.h"
#include "surface/distance_range.h"
#include "surface/flat_shading.h"
#include "surface/plane_distance.h"
#include "surface/preparation.h"
#include "surface/reading.h"
#include "surface/surface.h"
#include "surface/surface_coordinates.h"
#include "surface/view_ray.h"

namespace pyrasim {

/// The points p with normal . p = offset.
template <class Scalar>
struct PlaneSurface {
  static constexpr SurfaceTraits traits{.name = "plane", .default_cost = 1, .extent = Extent::unbounded};
  using Terms = const ViewRay<Scalar>&;
  using Shading = FlatShading<Scalar>;

  Vector<Scalar> normal;  ///< of any length
  Scalar offset;
  SurfaceIdentity identity{};
  PlaneError error{};

  Scalar intersect(const ViewRay<Scalar>& ray) const { return plane_distance(normal, offset, ray.direction); }
  Scalar shade(const Shading& shading, const Lighting<Scalar>&, const Vector<Scalar>& direction, Scalar) const {
    return shading.seen_along(direction);
  }
  Vector<Scalar> outward(const Shading& shading, const Vector<Scalar>&, Scalar) const { return shading.normal; }

  /// The same surface for rays that start at `place` instead of the origin.
  PlaneSurface seen_from(const Vector<Scalar>& place) const {
    return {normal, offset - compensated_dot(normal, place), identity};
  }

  template <class Other, class Number>
  PlaneSurface<Other> mapped(const Number& number) const {
    return {number(normal, 0), number(offset, 1), identity, error};
  }
};

double reach(const PlaneSurface<double>& plane);
PlaneError relative_error(const PlaneSurface<double>& plane, const RoundingUnits& rounding);
DistanceRange distance_range(const PlaneSurface<double>& plane, const Vector<double>& direction, double t,
                             const RoundingUnits& rounding);
std::optional<BoundingBox> slope_bounds(const PlaneSurface<double>& plane, double margin);
std::optional<BoundingBox> bounds(const PlaneSurface<double>& plane);

/// The plane through points p with normal . (p - the observer's place) = `offset`, in the world's coordinates. The
/// normal keeps the length that it has, but for a power of two: at length 1 its components would be rounded, by as much
/// as the rest of t's computation errs.
Prepared<PlaneSurface> prepared_plane(const glm::dvec3& normal, Quadruple offset, const Preparation& preparation);

class AffineMap;

/// The points p with normal . p = offset. The normal has any length but zero.
struct Plane {
  static constexpr std::string_view type = "plane";
  static constexpr std::array<std::string_view, 2> keys{"normal", "offset"};

  glm::dvec3 normal;
  double offset;

  static Plane read(const JsonReader& reader, const SceneReading& reading);
  Prepared<PlaneSurface> prepared(const Preparation& preparation) const;
  Plane transformed(const AffineMap& map) const;
  SurfaceCoordinates coordinates_at(const glm::dvec3& point) const;
  void write_pov(PovWriter& pov) const;
};

}  // namespace pyrasim
