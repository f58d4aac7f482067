// SPDX-License-Identifier: Apache-2.0
#include "surface/sphere.h"

#include <cmath>

#include "numeric/quadruple.h"
#include "numeric/vectors.h"
#include "surface/affine_map.h"
#include "surface/ellipsoid.h"
#include "surface/error_bounds.h"
#include "surface/pov_writer.h"
#include "surface/slope_bounds.h"

namespace pyrasim {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The power of the observer's place, |centre - place|^2 - radius^2. It cancels just above a sphere, by a factor of
/// 2 height / radius; exact to double's rounding down to heights of 2^-60 radii. What is less than the rounding of
/// the coordinates given is on the surface.
double power_of(const Sphere& sphere, const glm::dvec3& place) {
  Quadruple power = -static_cast<Quadruple>(sphere.radius) * sphere.radius;
  for (int axis = 0; axis < 3; ++axis) {
    const Quadruple away = static_cast<Quadruple>(sphere.center[axis]) - place[axis];
    power += away * away;
  }
  const double size = sphere.radius + largest(sphere.center) + largest(place);
  const double rounding = 4 * epsilon<double>() * sphere.radius * size;
  return std::abs(static_cast<double>(power)) > rounding ? static_cast<double>(power) : 0;
}

/// The steps of SphereSurface::intersect(), each with its error.
class SphereSteps {
 public:
  SphereSteps(const SphereSurface<double>& sphere, const Vector<double>& direction, const RoundingUnits& rounding)
      : sphere_(sphere),
        direction_(direction),
        u_(rounding.relative),
        a_(rounding.absolute),
        written_(rounding.written(largest(sphere.center) + sphere.radius)) {}

  /// By how much t errs.
  double error(double t) const {
    const Bounded inverse = inverse_length_squared();
    const Bounded along = along_ray();
    const Bounded closest = product(along, inverse);
    const Bounded chord = half_chord(product(sphere_.power > 0 ? across(closest) : inside(along, closest), inverse));
    const double outer = std::abs(closest.value) + chord.value;
    const double outer_error = closest.error + chord.error + u_ * outer;
    const bool is_quotient = sphere_.power > 0 || along.value < 0;
    if (!is_quotient) return outer_error;
    if (!(outer > outer_error)) return infinity;
    const Bounded numerator = product({std::abs(sphere_.power), power_error()}, inverse);
    return (numerator.error + t * outer_error) / (outer - outer_error) + u_ * t + a_;
  }

 private:
  Bounded product(const Bounded& p, const Bounded& q) const {
    const double value = p.value * q.value;
    return {value, p.error * (std::abs(q.value) + q.error) + std::abs(p.value) * q.error + u_ * std::abs(value) + a_};
  }

  /// c . d: the centre's rounding, three products and two sums.
  Bounded along_ray() const {
    const auto d = magnitudes(direction_);
    return {dot(sphere_.center, direction_),
            4 * u_ * dot(magnitudes(sphere_.center), d) + (a_ + written_) * sum(d) + 3 * a_};
  }

  /// 1 / d . d: three products, two sums and the quotient.
  Bounded inverse_length_squared() const {
    const double inverse = 1 / dot(direction_, direction_);
    return {inverse, inverse * (4 * u_ + 3 * a_ * inverse) + a_};
  }

  /// |c|^2 - r^2, rounded once; the centre and the radius as written.
  double power_error() const {
    const double size = sum(magnitudes(sphere_.center)) + sphere_.radius;
    return u_ * std::abs(sphere_.power) + a_ + 2 * size * written_;
  }

  /// From outside: r^2 - p . p, where p = c - t d is the centre's component across the ray. An error of t moves p along
  /// the ray, at a right angle to itself: it counts in second order.
  Bounded across(const Bounded& closest) const {
    const auto p = sphere_.center - direction_ * closest.value;
    const double moved = closest.error * length(direction_);
    const double away = length(p);
    const double p_error = u_ * (2 * length(sphere_.center) + away) + 2 * (2 * a_ + written_);
    const double r_squared = sphere_.radius_squared;
    const double value = r_squared - away * away;
    return {value, 2 * away * p_error + (p_error + moved) * (p_error + moved) + 3 * u_ * away * away + 4 * a_ +
                       u_ * r_squared + 2 * sphere_.radius * written_ + u_ * std::abs(value)};
  }

  /// From inside: a sum of two positive terms.
  Bounded inside(const Bounded& along, const Bounded& closest) const {
    const Bounded square = product(along, closest);
    const double value = square.value - sphere_.power;
    return {value, square.error + power_error() + u_ * value};
  }

  /// A root errs by its square's error over twice the root, or by that error's root where it is about 0.
  Bounded half_chord(const Bounded& square) const {
    const double value = std::sqrt(std::max(square.value, 0.0));
    const bool small = square.value < 2 * square.error;
    const double error =
        small ? std::sqrt(square.error) : square.error / (value + std::sqrt(square.value - square.error));
    return {value, error + u_ * value + a_};
  }

  const SphereSurface<double>& sphere_;
  const Vector<double>& direction_;
  double u_;
  double a_;
  double written_;
};

}  // namespace

Sphere Sphere::read(const JsonReader& reader, const SceneReading&) {
  return {reader.member("center").vec3(coordinates), reader.member("radius").number(lengths)};
}

Prepared<SphereSurface> Sphere::prepared(const Preparation& preparation) const {
  const double power = power_of(*this, preparation.frame.position());
  return {{preparation.frame.point(center), radius * radius, power, radius}, {}};
}

std::variant<Sphere, Ellipsoid> Sphere::transformed(const AffineMap& map) const {
  if (const auto factor = map.similarity()) return Sphere{mapped_point(map, center), mapped_length(*factor * radius)};
  return Ellipsoid{center, glm::dvec3(radius)}.transformed(map);
}

void Sphere::write_pov(PovWriter& pov) const { pov.object("sphere", center, radius); }

double reach(const SphereSurface<double>& sphere) { return largest(sphere.center) + sphere.radius; }

std::optional<BoundingBox> bounds(const SphereSurface<double>& sphere) {
  return BoundingBox{sphere.center - sphere.radius, sphere.center + sphere.radius};
}

std::optional<BoundingBox> slope_bounds(const SphereSurface<double>& sphere, double margin) {
  return slope_bounds_of_sphere(sphere.center, sphere.radius, margin);
}

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

DistanceRange distance_range(const SphereSurface<double>& surface, const Vector<double>& direction, double t,
                             const RoundingUnits& rounding) {
  const double error = SphereSteps(surface, direction, rounding).error(t) * second_order(rounding);
  const double size = std::abs(surface.center.x) + surface.radius;
  const double margin =
      rounding.relative * size + 2 * rounding.absolute + rounding.written(largest(surface.center) + surface.radius);
  return within_bounds({t - error, t + error}, surface.center.x - surface.radius - margin,
                       surface.center.x + surface.radius + margin, direction);
}

SurfaceCoordinates Sphere::coordinates_at(const glm::dvec3& point) const { return on_sphere(point - center); }

}  // namespace pyrasim
