// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <limits>
#include <optional>

#include "surface/bounding_box.h"
#include "surface/curved_shading.h"
#include "surface/distance_range.h"
#include "surface/preparation.h"
#include "surface/quadric_range.h"
#include "surface/reading.h"
#include "surface/surface.h"
#include "surface/surface_coordinates.h"
#include "surface/torus_along_ray.h"

namespace pyrasim {

template <class Scalar>
struct TorusSurface {
  static constexpr SurfaceTraits traits{.name = "torus", .default_cost = 25, .extent = Extent::bounded};
  using Terms = const ViewRay<Scalar>&;
  using Shading = NoShading<Scalar>;

  Vector<Scalar> center;
  Vector<Scalar> axis;  ///< of length 1
  Scalar major;         ///< from the centre to the middle of the tube
  Scalar minor;         ///< of the tube
  Scalar side;          ///< of the origin: 1 outside, -1 in the tube, 0 on the surface
  SurfaceIdentity identity{};

  Scalar intersect(const ViewRay<Scalar>& ray) const;
  Vector<Scalar> outward(const Shading&, const Vector<Scalar>& direction, Scalar t) const;
  Scalar shade(const Shading& shading, const Lighting<Scalar>& lighting, const Vector<Scalar>& direction,
               Scalar t) const {
    return lighting.lit ? lambert_of_curved(lighting, outward(shading, direction, t), direction) : Scalar(1);
  }

  /// The same surface for rays that start at `place` instead of the origin.
  TorusSurface seen_from(const Vector<Scalar>& place) const;

  template <class Other, class Number>
  TorusSurface<Other> mapped(const Number& number) const {
    return {number(center, 1), number(axis, 0), number(major, 1), number(minor, 1), number(side, 0), identity};
  }
};

double reach(const TorusSurface<double>& torus);
double relative_error(const TorusSurface<double>& torus, const RoundingUnits& rounding);
DistanceRange distance_range(const TorusSurface<double>& torus, const Vector<double>& direction, double t,
                             const RoundingUnits& rounding);
std::optional<BoundingBox> slope_bounds(const TorusSurface<double>& torus, double margin);
std::optional<BoundingBox> bounds(const TorusSurface<double>& torus);

/// How far from the surface a place may lie that counts as one of it: by the kernel's arithmetic alone, and by what
/// the scene's numbers have lost on their way as well.
double displacement_of_kernel(const TorusSurface<double>& torus, const RoundingUnits& rounding);
double displacement(const TorusSurface<double>& torus, const RoundingUnits& rounding);
/// Where a surface may be hit first all of whose places lie within `displacement` of the torus.
FirstHitRange first_hit_range(const TorusSurface<double>& torus, const Vector<double>& direction, double displacement);

class AffineMap;

/// A ring: a circle about an axis, and all that lies within `minor_radius` of it. Seen from outside and inside.
struct Torus {
  static constexpr std::string_view type = "torus";
  static constexpr std::array<std::string_view, 4> keys{"center", "axis", "major_radius", "minor_radius"};

  glm::dvec3 center;
  glm::dvec3 axis;  ///< of any length
  double major_radius;
  double minor_radius;  ///< at most major_radius: beyond, the tube would meet itself

  static Torus read(const JsonReader& reader, const SceneReading& reading);
  Prepared<TorusSurface> prepared(const Preparation& preparation) const;
  /// By a similarity: else it would be no torus.
  Torus transformed(const AffineMap& map) const;
  SurfaceCoordinates coordinates_at(const glm::dvec3& point) const;
  void write_pov(PovWriter& pov) const;
};

/// From `negative`, where f is not above 0 and not concave, to where the parabola that touches f there is 0: towards
/// `positive`.
template <class Scalar>
Scalar parabola_root(const Expansion<Scalar>& f, Scalar negative, Scalar positive) {
  using std::sqrt;  // or that of the number format
  if (!(f.curvature > Scalar(0))) return negative;
  const Scalar root = sqrt(std::max(f.slope * f.slope - f.curvature * f.value, Scalar(0)));
  return negative + ((positive > negative ? root : -root) - f.slope) / f.curvature;
}

/// Where f first has another sign than at the ray's origin, given places at which it may turn: between that place and
/// the one before there is one root. Beyond `end` f is positive.
template <class Scalar>
class TorusSearch {
 public:
  using Along = TorusAlongRay<Scalar>;
  TorusSearch(const Along& f, Scalar begin, Scalar end, bool inside)
      : f_(f), inside_(inside), from_(begin), end_(end) {}

  /// Whether the root is before `place`; else looks on from there. Places come in order.
  bool passes(const typename Along::Place& place) {
    if (!(place.s > from_)) return false;
    const bool changes = inside_ ? place.f.value >= Scalar(0) : place.f.value <= Scalar(0);
    if (!changes) {
      from_ = std::min(place.s, end_);
      return false;
    }
    const Scalar to = std::min(place.s, end_);
    root_ = inside_ ? bracketed_root(f_, to, from_, parabola_root(f_(from_), from_, to))
                    : bracketed_root(f_, from_, to, parabola_root(place.f, place.s, from_));
    return true;
  }
  /// As if `end` were such a place.
  void end() { root_ = bracketed_root(f_, end_, from_, parabola_root(f_(from_), from_, end_)); }

  Scalar root() const { return root_; }

 private:
  const Along& f_;
  bool inside_;
  Scalar from_;
  Scalar end_;
  Scalar root_{0};
};

/// From within the tube there is a root ahead.
template <class Scalar>
Scalar root_from_inside(const TorusAlongRay<Scalar>& f, Scalar begin, Scalar end) {
  TorusSearch<Scalar> search(f, begin, end, true);
  const Scalar none = std::numeric_limits<Scalar>::max();
  if (!search.passes(f.first_least(none)) && !search.passes(f.greatest()) && !search.passes(f.last_least(none))) {
    search.end();
  }
  return search.root();
}

/// From outside. An observer on the surface has a root at `begin`, next to which f may be negative by its rounding: for
/// him only the minima themselves count.
template <class Scalar>
std::optional<Scalar> root_from_outside(const TorusAlongRay<Scalar>& f, Scalar begin, Scalar end, bool on_surface) {
  TorusSearch<Scalar> search(f, begin, end, false);
  const Scalar enough = on_surface ? std::numeric_limits<Scalar>::max() : begin;
  if (search.passes(f.first_least(enough)) || search.passes(f.last_least(enough))) return search.root();
  return std::nullopt;
}

/// The smallest t > 0 at which a ray meets the surface, or 0 where there is none. Of an observer on the surface the
/// place that he stands on does not count: he looks into the tube, or away from it.
///
/// Not inlined into the walk, which all other surfaces share.
template <class Scalar>
[[gnu::noinline]] Scalar first_hit(const TorusSurface<Scalar>& torus, const ViewRay<Scalar>& ray) {
  using std::sqrt;  // or that of the number format
  const CenteredRay<Scalar> about(torus.center, torus.major + torus.minor, ray);
  const Scalar half_chord = sqrt(std::max(about.room, Scalar(0)) * ray.inverse_length_squared);
  const Scalar end = about.nearest + half_chord;
  const Scalar origin = -about.start;
  const bool ahead = about.room >= Scalar(0) && end > origin;
  if (torus.side > Scalar(0) && !ahead) return Scalar(0);
  const TorusAlongRay<Scalar> f(torus, about);
  const bool inside = torus.side < Scalar(0) || (torus.side == Scalar(0) && f(origin).slope < Scalar(0));
  const Scalar begin = std::max(origin, about.nearest - half_chord);
  if (inside) {
    const Scalar t = about.start + root_from_inside(f, begin, end);
    const Scalar least = std::max(epsilon<Scalar>() * torus.major, std::numeric_limits<Scalar>::denorm_min());
    return std::max(t, least);  // the wall is before him, however near
  }
  const std::optional<Scalar> root = root_from_outside(f, begin, end, torus.side == Scalar(0));
  return root ? std::max(about.start + *root, Scalar(0)) : Scalar(0);
}

template <class Scalar>
Scalar TorusSurface<Scalar>::intersect(const ViewRay<Scalar>& ray) const {
  return first_hit(*this, ray);
}

/// Outward at the place that the ray meets at t, of any length.
template <class Scalar>
Vector<Scalar> TorusSurface<Scalar>::outward(const Shading&, const Vector<Scalar>& direction, Scalar t) const {
  using std::sqrt;  // or that of the number format
  const Vector<Scalar> place = direction * t - center;
  const Scalar height = dot(axis, place);
  const Vector<Scalar> across = place - axis * height;
  const Scalar rho = sqrt(dot(across, across));
  if (!(rho > Scalar(0))) return axis * height;
  return across * ((rho - major) / rho) + axis * height;
}

template <class Scalar>
TorusSurface<Scalar> TorusSurface<Scalar>::seen_from(const Vector<Scalar>& place) const {
  using std::sqrt;  // or that of the number format
  TorusSurface moved = *this;
  moved.center = center - place;
  const Scalar height = dot(axis, moved.center);
  const Vector<Scalar> across = moved.center - axis * height;
  const Scalar beyond = sqrt(dot(across, across)) - major;
  const Scalar excess = beyond * beyond + height * height - minor * minor;
  moved.side = excess > Scalar(0) ? Scalar(1) : excess < Scalar(0) ? Scalar(-1) : Scalar(0);
  return moved;
}

}  // namespace pyrasim
