// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

#include "surface/bounding_box.h"
#include "surface/distance_range.h"
#include "surface/lighting.h"
#include "surface/preparation.h"
#include "surface/reading.h"
#include "surface/surface.h"
#include "surface/surface_coordinates.h"
#include "surface/view_ray.h"

namespace pyrasim {

template <class Scalar>
struct SphereSurface {
  static constexpr SurfaceTraits traits{.name = "sphere", .default_cost = 2, .extent = Extent::bounded};
  using Terms = const ViewRay<Scalar>&;
  using Shading = NoShading<Scalar>;

  Vector<Scalar> center;
  Scalar radius_squared;
  Scalar power;   ///< |center|^2 - radius^2, the origin's power: positive outside; rounded once
  Scalar radius;  ///< for the normal
  SurfaceIdentity identity{};

  Scalar intersect(const ViewRay<Scalar>& ray) const;
  Scalar shade(const Shading&, const Lighting<Scalar>& lighting, const Vector<Scalar>& direction, Scalar t) const;
  Vector<Scalar> outward(const Shading&, const Vector<Scalar>& direction, Scalar t) const {
    return direction * t - center;
  }

  /// The same surface for rays that start at `place` instead of the origin.
  SphereSurface seen_from(const Vector<Scalar>& place) const {
    const Vector<Scalar> moved = center - place;
    return {moved, radius_squared, dot(moved, moved) - radius_squared, radius, identity};
  }

  template <class Other, class Number>
  SphereSurface<Other> mapped(const Number& number) const {
    return {number(center, 1), number(radius_squared, 2), number(power, 2), number(radius, 1), identity};
  }
};

double reach(const SphereSurface<double>& sphere);
double relative_error(const SphereSurface<double>& sphere, const RoundingUnits& rounding);
DistanceRange distance_range(const SphereSurface<double>& sphere, const Vector<double>& direction, double t,
                             const RoundingUnits& rounding);
std::optional<BoundingBox> slope_bounds(const SphereSurface<double>& sphere, double margin);
std::optional<BoundingBox> bounds(const SphereSurface<double>& sphere);

class AffineMap;
struct Ellipsoid;

struct Sphere {
  static constexpr std::string_view type = "sphere";
  static constexpr std::array<std::string_view, 2> keys{"center", "radius"};

  glm::dvec3 center;
  double radius;

  static Sphere read(const JsonReader& reader, const SceneReading& reading);
  Prepared<SphereSurface> prepared(const Preparation& preparation) const;
  std::variant<Sphere, Ellipsoid> transformed(const AffineMap& map) const;
  SurfaceCoordinates coordinates_at(const glm::dvec3& point) const;
  void write_pov(PovWriter& pov) const;
};

/// The smallest t > 0 at which the view ray t * direction meets the sphere, or 0 where there is none.
///
/// From outside the discriminant comes from the component of the centre perpendicular to the ray (Haines, Günther,
/// Akenine-Möller, Ray Tracing Gems, chapter 7): far and small spheres keep their outline where b^2 - 4ac would lose
/// it. For an observer inside the sphere or on it b^2 - 4ac is a sum of two positive terms: no ray of his misses it. On
/// it c, the power, is 0, and so is one root: he does not see the place that he stands on. The roots come from the sum
/// that does not cancel, and from their product.
template <class Scalar>
Scalar SphereSurface<Scalar>::intersect(const ViewRay<Scalar>& ray) const {
  const Vector<Scalar>& direction = ray.direction;
  const Scalar along = dot(center, direction);
  if (along <= Scalar(0) && power >= Scalar(0)) return Scalar(0);  // it lies behind, or he looks away from it
  const Scalar t_closest = along * ray.inverse_length_squared;
  Scalar discriminant{};  // over 4 direction . direction
  if (power > Scalar(0)) {
    const Vector<Scalar> perpendicular{center.x - t_closest * direction.x, center.y - t_closest * direction.y,
                                       center.z - t_closest * direction.z};
    discriminant = radius_squared - dot(perpendicular, perpendicular);
    if (!(discriminant >= Scalar(0))) return Scalar(0);
  } else {
    discriminant = along * t_closest - power;
  }
  using std::sqrt;  // or that of the number format
  const Scalar half_chord = sqrt(discriminant * ray.inverse_length_squared);
  const Scalar t_outer = along < Scalar(0) ? t_closest - half_chord : t_closest + half_chord;  // the larger |t|
  if (t_outer == Scalar(0)) return Scalar(0);
  const Scalar t_inner = power * ray.inverse_length_squared / t_outer;  // product of roots = power / length^2
  if (t_inner > Scalar(0)) return t_inner;  // from outside the nearer root; from inside the only one ahead
  return t_outer > Scalar(0) ? t_outer : Scalar(0);
}

/// Lambert's cosine law on the side that the ray meets; a cosine beyond 1, or none at all, is a narrow format's
/// mistake.
template <class Scalar>
Scalar SphereSurface<Scalar>::shade(const Shading&, const Lighting<Scalar>& lighting, const Vector<Scalar>& direction,
                                    Scalar t) const {
  if (!lighting.lit) return Scalar(1);
  const Scalar side = power < Scalar(0) ? -radius : radius;
  const Scalar cosine = dot(outward({}, direction, t), lighting.towards_light) / side;
  return lambert(lighting, std::min(std::max(Scalar(0), cosine), Scalar(1)));
}

}  // namespace pyrasim
