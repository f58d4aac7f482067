// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "numeric/compensated.h"
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

/// The points p of a plane, normal . p = offset, with |p - center| <= radius.
template <class Scalar>
struct DiscSurface {
  static constexpr SurfaceTraits traits{.name = "disc", .default_cost = 2, .extent = Extent::bounded};
  using Terms = const ViewRay<Scalar>&;
  using Shading = FlatShading<Scalar>;

  Vector<Scalar> normal;  ///< of any length
  Scalar offset;
  Vector<Scalar> center;
  Scalar radius_squared;
  SurfaceIdentity identity{};

  Scalar intersect(const ViewRay<Scalar>& ray) const;
  Scalar shade(const Shading& shading, const Lighting<Scalar>&, const Vector<Scalar>& direction, Scalar) const {
    return shading.seen_along(direction);
  }
  Vector<Scalar> outward(const Shading& shading, const Vector<Scalar>&, Scalar) const { return shading.normal; }

  /// The same surface for rays that start at `place` instead of the origin.
  DiscSurface seen_from(const Vector<Scalar>& place) const {
    return {normal, offset - compensated_dot(normal, place), center - place, radius_squared, identity};
  }

  template <class Other, class Number>
  DiscSurface<Other> mapped(const Number& number) const {
    return {number(normal, 0), number(offset, 1), number(center, 1), number(radius_squared, 2), identity};
  }
};

double reach(const DiscSurface<double>& disc);
double relative_error(const DiscSurface<double>& disc, const RoundingUnits& rounding);
DistanceRange distance_range(const DiscSurface<double>& disc, const Vector<double>& direction, double t,
                             const RoundingUnits& rounding);
std::optional<BoundingBox> slope_bounds(const DiscSurface<double>& disc, double margin);
std::optional<BoundingBox> bounds(const DiscSurface<double>& disc);

class AffineMap;

/// A flat disc, seen from both sides. The normal has any length but zero.
struct Disc {
  static constexpr std::string_view type = "disc";
  static constexpr std::array<std::string_view, 3> keys{"center", "normal", "radius"};

  glm::dvec3 center;
  glm::dvec3 normal;
  double radius;

  static Disc read(const JsonReader& reader, const SceneReading& reading);
  Prepared<DiscSurface> prepared(const Preparation& preparation) const;
  /// By a similarity: else it would be an ellipse.
  Disc transformed(const AffineMap& map) const;
  SurfaceCoordinates coordinates_at(const glm::dvec3& point) const;
  void write_pov(PovWriter& pov) const;
};

/// The t > 0 at which the view ray meets the disc, or 0 where there is none: t is that of its plane, and the
/// place there has to lie within the radius, the rim included.
template <class Scalar>
Scalar DiscSurface<Scalar>::intersect(const ViewRay<Scalar>& ray) const {
  const Scalar t = plane_distance(normal, offset, ray.direction);
  if (t == Scalar(0)) return Scalar(0);
  const Vector<Scalar> from_center = ray.direction * t - center;
  return dot(from_center, from_center) <= radius_squared ? t : Scalar(0);
}

}  // namespace pyrasim
