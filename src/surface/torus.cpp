// SPDX-License-Identifier: Apache-2.0
#include "surface/torus.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "numeric/quadruple.h"
#include "numeric/vectors.h"
#include "surface/affine_map.h"
#include "surface/error_bounds.h"
#include "surface/pov_writer.h"
#include "surface/slope_bounds.h"

namespace pyrasim {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Of the observer, in 113 bits. What is less than the rounding of the coordinates given is on the surface.
double side_of(const Torus& torus, const QuadrupleVector& axis, const glm::dvec3& observer) {
  const QuadrupleVector place = difference(exactly(observer), exactly(torus.center));
  const Quadruple height = dot(axis, place);
  QuadrupleVector across = place;
  for (std::size_t k = 0; k < 3; ++k) across[k] -= height * axis[k];
  const Quadruple beyond = length(across) - torus.major_radius;
  const auto above = static_cast<double>(square_root(beyond * beyond + height * height) - torus.minor_radius);
  const double size = torus.major_radius + torus.minor_radius + largest(torus.center) + largest(observer);
  if (std::abs(above) <= 4 * epsilon<double>() * size) return 0;
  return above > 0 ? 1 : -1;
}

double outer_radius(const TorusSurface<double>& torus) { return torus.major + torus.minor; }

/// Of the observer, from the surface.
double distance_of_origin(const TorusSurface<double>& torus) {
  const double height = dot(torus.axis, torus.center);
  const double from_axis = length(torus.center - torus.axis * height);
  return std::abs(std::hypot(from_axis - torus.major, height) - torus.minor);
}

/// Two directions of length 1 across `axis` and each other.
std::array<glm::dvec3, 2> across(const glm::dvec3& axis) {
  const glm::dvec3 sizes = magnitudes(axis);
  glm::dvec3 other(0);
  other[sizes.x <= sizes.y && sizes.x <= sizes.z ? 0 : sizes.y <= sizes.z ? 1 : 2] = 1;
  const glm::dvec3 u = cross(axis, other) / length(cross(axis, other));
  return {u, cross(axis, u) / length(axis)};
}

/// Of the prism with eight sides about the torus.
std::array<glm::dvec3, 16> corners_about(const TorusSurface<double>& torus) {
  const glm::dvec3& axis = torus.axis;
  const auto [u, v] = across(axis);
  const double radius = outer_radius(torus) / std::cos(std::numbers::pi / 8);
  std::array<glm::dvec3, 16> corners;
  for (std::size_t side = 0; side < 8; ++side) {
    const double angle = (static_cast<double>(side) + 0.5) * (std::numbers::pi / 4);
    const glm::dvec3 edge = torus.center + (u * std::cos(angle) + v * std::sin(angle)) * radius;
    corners[2 * side] = edge + axis * torus.minor;
    corners[2 * side + 1] = edge - axis * torus.minor;
  }
  return corners;
}

}  // namespace

Torus Torus::read(const JsonReader& reader, const SceneReading&) {
  const Torus torus{reader.member("center").vec3(coordinates), read_direction(reader.member("axis")),
                    reader.member("major_radius").number(lengths), reader.member("minor_radius").number(lengths)};
  if (torus.minor_radius > torus.major_radius) {
    reader.member("minor_radius")
        .fail(fmt::format("{} is more than major_radius, and the tube would meet itself", torus.minor_radius),
              fmt::format("at most {} is allowed", torus.major_radius));
  }
  return torus;
}

Prepared<TorusSurface> Torus::prepared(const Preparation& preparation) const {
  const QuadrupleVector along = unit(exactly(axis));
  const auto& frame = preparation.frame;
  return {{frame.point(center), frame.direction(rounded(along)), major_radius, minor_radius,
           side_of(*this, along, frame.position())},
          {}};
}

Torus Torus::transformed(const AffineMap& map) const {
  const Quadruple factor = required_similarity(map, "torus", "a ring of another form");
  return {mapped_point(map, center), rounded(unit(map.normal(exactly(axis)))), mapped_length(factor * major_radius),
          mapped_length(factor * minor_radius)};
}

/// POV-Ray's own lies about the y axis.
void Torus::write_pov(PovWriter& pov) const {
  const glm::dvec3 up = normalized(axis);
  const auto [u, v] = across(up);
  pov.begin("torus");
  pov.add(major_radius, minor_radius);
  pov.matrix({u, up, v}, center);
  pov.end();
}

double reach(const TorusSurface<double>& torus) { return largest(torus.center) + outer_radius(torus); }

std::optional<BoundingBox> bounds(const TorusSurface<double>& torus) {
  glm::dvec3 half(0);
  for (int k = 0; k < 3; ++k) {
    const double across = std::sqrt(std::max(1 - torus.axis[k] * torus.axis[k], 0.0));
    half[k] = torus.major * across + torus.minor;
  }
  return BoundingBox{torus.center - half, torus.center + half};
}

std::optional<BoundingBox> slope_bounds(const TorusSurface<double>& torus, double margin) {
  return slope_bounds_of_hull(corners_about(torus), margin);
}

/// A ray that grazes the tube may count as one that misses it, and meet its other side: nothing holds for every ray.
double relative_error(const TorusSurface<double>&, const RoundingUnits&) { return infinity; }

/// Errors of a place that TorusAlongRay looks at, as the square root of the sum of those of its coordinates: the
/// centre's; of the product and the difference that make the place at `start`; the axis'; three roundings of each of
/// two heights, two of each vector across, a product and a sum of both; the root of three squares; the radii; and of f,
/// by 2 r, three squares, their sum and their difference. `size` is what a place, and the way there, amounts to:
/// `start` is 9 roundings of the centre's distance from where the ray comes nearest.
double displacement_of_kernel(const TorusSurface<double>& torus, const RoundingUnits& rounding) {
  const double u = rounding.relative;
  const double a = rounding.absolute;
  const double away = length(torus.center);
  const double radii = outer_radius(torus);
  const double size = radii + 9 * u * away + (12 * away + 8) * a;
  const double lost = std::sqrt(3 * a);  // the root of what three squares lose
  const auto root = [&](double of) { return of > 0 ? std::min(1.5 * a / of, lost) : lost; };
  const double relative = u * (3 * away + 12.5 * size + 3.5 * radii + 6 * torus.minor);
  const double absolute = a * (14 + 7 * size) + root(torus.major - torus.minor) + root(torus.minor);
  return second_order(rounding) * (relative + absolute);
}

/// The centre and both radii as written, and the axis, which was turned.
double displacement(const TorusSurface<double>& torus, const RoundingUnits& rounding) {
  return displacement_of_kernel(torus, rounding) + 4 * rounding.written(reach(torus)) +
         22 * 0x1p-53 * outer_radius(torus);
}

/// The torus grown by as much, and the torus shrunk: rays that surely meet it meet the smaller one, and before they
/// meet its surface they have met the larger one's; from inside it is the other way round. An observer so close that he
/// stands in the larger one may meet it at once.
FirstHitRange first_hit_range(const TorusSurface<double>& torus, const Vector<double>& direction, double displacement) {
  const ViewRay<double> ray(direction);
  const auto hit = [&](double by) {
    TorusSurface<double> changed = torus;
    changed.minor += by;
    return changed.minor > 0 ? changed.intersect(ray) : 0;
  };
  const double outward = hit(displacement);
  const double inward = hit(-displacement);
  const bool leaves = torus.side < 0 || (torus.side == 0 && inward > 0 && inward < outward);
  FirstHitRange first;
  if (leaves) {
    first.add({inward, outward}, inward > 0);
  } else if (outward > 0 || distance_of_origin(torus) < displacement) {
    first.add({outward, inward > 0 ? inward : infinity}, inward > 0);
  }
  return first;
}

DistanceRange distance_range(const TorusSurface<double>& torus, const Vector<double>& direction, double t,
                             const RoundingUnits& rounding) {
  const RoundingUnits with_own{rounding.relative + 0x1p-53, rounding.absolute, rounding.place};
  const FirstHitRange first = first_hit_range(torus, direction, displacement(torus, with_own));
  DistanceRange range{t, t};
  if (first.possible()) range = {std::min(t, first.range().lowest), std::max(t, first.range().highest)};
  const BoundingBox box = *bounds(torus);
  const double margin = 4 * rounding.relative * reach(torus) + 2 * rounding.absolute + rounding.written(reach(torus));
  return within_bounds(range, box.lower.x - margin, box.upper.x + margin, direction);
}

/// v: the angle about the middle of the tube, in turns; 0 on the outer side, and growing along the axis.
SurfaceCoordinates Torus::coordinates_at(const glm::dvec3& point) const {
  SurfaceCoordinates result = about_axis(axis, center, point);
  const glm::dvec3 along = normalized(axis);
  const glm::dvec3 from = point - center;
  const double outward = length(from - along * dot(along, from)) - major_radius;
  result.v = std::atan2(result.v, outward) / (2 * std::numbers::pi);
  result.v_turns = true;
  return result;
}

}  // namespace pyrasim
