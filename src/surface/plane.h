// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <limits>

#include "numeric/compensated.h"
#include "surface/bounding_box.h"
#include "surface/distance_range.h"
#include "surface/flat_shading.h"
#include "surface/plane_distance.h"
#include "surface/preparation.h"
#include "surface/reading.h"
#include "surface/surface.h"
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

  Scalar intersect(const ViewRay<Scalar>& ray) const;
  Scalar shade(const Shading& shading, const Lighting<Scalar>&, const Vector<Scalar>& direction, Scalar) const {
    return shading.seen_along(direction);
  }

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

/// The points p with normal . p = offset. The normal has any length but zero.
struct Plane {
  static constexpr std::string_view type = "plane";
  static constexpr std::array<std::string_view, 2> keys{"normal", "offset"};

  glm::dvec3 normal;
  double offset;

  static Plane read(const JsonReader& reader, const SceneReading& reading);
  Prepared<PlaneSurface> prepared(const Preparation& preparation) const;
};

/// The t > 0 at which the view ray meets the plane, or 0 where it runs parallel or away from it.
///
/// A grazing ray's n . d is what is left of terms that cancel: summed plainly it loses as many digits as the angle has
/// zeros. Compensated it is right to 1 ulp down to angles of 2^-P, and t, one division later, to 2. The offset, which
/// the observer's distance would spoil likewise, is worked out exactly and rounded once when the scene is prepared.
template <class Scalar>
Scalar PlaneSurface<Scalar>::intersect(const ViewRay<Scalar>& ray) const {
  const Scalar approach = compensated_dot(normal, ray.direction);
  if (approach == Scalar(0)) return Scalar(0);
  const Scalar t = offset / approach;
  return t > Scalar(0) ? t : Scalar(0);
}

}  // namespace pyrasim
