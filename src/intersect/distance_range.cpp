// SPDX-License-Identifier: Apache-2.0
// Letters as in docs/numerics.md: u is the format's relative rounding, a its absolute one. Terms of second order that
// are not written out are covered by a factor 1 + 16u.
#include "intersect/distance_range.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "intersect/triangle.h"

namespace pyrasim {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double second_order(const RoundingUnits& rounding) { return 1 + 16 * rounding.relative; }

Vector<double> magnitudes(const Vector<double>& v) { return {std::abs(v.x), std::abs(v.y), std::abs(v.z)}; }
double sum(const Vector<double>& v) { return v.x + (v.y + v.z); }
double largest(const Vector<double>& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }
double length(const Vector<double>& v) { return std::sqrt(dot(v, v)); }

/// t +- error, but no further than the surface's bounds along x. Comparisons are such that infinities cannot make a
/// NaN.
DistanceRange within_bounds(double t, double error, double begin, double end, const Vector<double>& direction) {
  const bool forward = direction.x > 0;
  DistanceRange range{forward ? begin / direction.x : -infinity, forward ? end / direction.x : infinity};
  if (t - error > range.lowest) range.lowest = t - error;
  if (t + error < range.highest) range.highest = t + error;
  range.highest = std::max(range.lowest, range.highest);
  return range;
}

struct Bounded {
  double value;
  double error;
};

/// The steps of intersect_sphere(), each with its error.
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

/// A triangle's vertices as the shear moves them, and the edge functions of these.
class ShearedTriangle {
 public:
  ShearedTriangle(const TriangleSurface<double>& triangle, const Vector<double>& direction,
                  const RoundingUnits& rounding)
      : shear_(direction),
        u_(rounding.relative),
        a_(rounding.absolute),
        scale_(direction[static_cast<int>(shear_.kz)]) {
    for (std::size_t k = 0; k < 3; ++k) {
      for (const double coordinate : triangle.vertices[k]) largest_ = std::max(largest_, std::abs(coordinate));
    }
    written_ = rounding.written(largest_);
    // Slopes are those of the view vector unless another component than x is its largest.
    slope_error_ = scale_ == 1 ? 0 : 2 * u_ + a_ * (1 + std::abs(scale_));
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& vertex = triangle.vertices[k];
      depth_[k] = vertex[shear_.kz];
      move(k, 0, vertex[shear_.kx], shear_.sx);
      move(k, 1, vertex[shear_.ky], shear_.sy);
    }
  }

  double largest() const { return largest_; }
  double written() const { return written_; }

  /// By how much t errs. The depth is the mean of the vertices' depths weighted by the edge functions, which have one
  /// sign where the triangle counts as hit: an error of a weight pulls it towards that vertex, and whatever the weights
  /// are, it lies between the vertices. To that come the errors of depths, products, sums and the quotient.
  double error(double t) const {
    const double depth = t * scale_;
    const double scale = std::abs(scale_);
    double determinant = 0, determinant_error = 0, weighted = 0, spread = 0, furthest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [edge, edge_error] = edge_function((k + 1) % 3, (k + 2) % 3);
      const double away = std::abs(depth_[k] - depth);
      determinant += edge;
      determinant_error += edge_error;
      weighted += edge_error * away;
      spread = std::max(spread, away);
      furthest = std::max(furthest, std::abs(depth_[k]));
    }
    const double certain = std::abs(determinant) - determinant_error;
    const double mean = certain > 0 ? std::min(weighted / certain, spread) : spread;
    const double own = 4 * u_ * (furthest + std::abs(depth)) + slope_error_ * std::abs(depth) + written_ +
                       a_ * (1 + scale) + a_ * (3 + scale) / std::max(certain, 2 * a_);
    return (mean + own) / scale;
  }

 private:
  /// The rounding of coordinates, of the product and of the difference.
  void move(std::size_t vertex, std::size_t axis, double coordinate, double slope) {
    const double product = slope * depth_[vertex];
    const double moved = coordinate - product;
    moved_[vertex][axis] = moved;
    error_[vertex][axis] = u_ * (std::abs(coordinate) + 2 * std::abs(product) + std::abs(moved)) +
                           std::abs(depth_[vertex]) * slope_error_ + (a_ + written_) * (1 + std::abs(slope)) + a_;
  }

  Bounded edge_function(std::size_t p, std::size_t q) const {
    double error = 2 * a_;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const double size_q = std::abs(moved_[q][axis]);
      const double size_p = std::abs(moved_[p][1 - axis]);
      error +=
          size_q * error_[p][1 - axis] + error_[q][axis] * (size_p + error_[p][1 - axis]) + 2 * u_ * size_q * size_p;
    }
    return {moved_[q][0] * moved_[p][1] - moved_[q][1] * moved_[p][0], error};
  }

  TriangleShear<double> shear_;
  double u_;
  double a_;
  double scale_;  ///< the view vector's component along which depths are
  double written_ = 0;
  double slope_error_ = 0;
  double largest_ = 0;
  std::array<double, 3> depth_{};
  std::array<std::array<double, 2>, 3> moved_{}, error_{};
};

}  // namespace

DistanceRange distance_range(const SphereSurface<double>& surface, const Vector<double>& direction, double t,
                             const RoundingUnits& rounding) {
  const double error = SphereSteps(surface, direction, rounding).error(t) * second_order(rounding);
  const double size = std::abs(surface.center.x) + surface.radius;
  const double margin =
      rounding.relative * size + 2 * rounding.absolute + rounding.written(largest(surface.center) + surface.radius);
  return within_bounds(t, error, surface.center.x - surface.radius - margin, surface.center.x + surface.radius + margin,
                       direction);
}

/// offset / n . d, each known to its error. The compensated sum adds 5u^2 of its terms, fixed point rounds two products
/// instead; here n . d is summed plainly, in double.
DistanceRange distance_range(const PlaneSurface<double>& surface, const Vector<double>& direction, double t,
                             const RoundingUnits& rounding) {
  const double u = rounding.relative;
  const double a = rounding.absolute;
  const auto n = magnitudes(surface.shading.normal);
  const auto d = magnitudes(direction);
  const double terms = dot(n, d);
  const double approach = std::abs(dot(surface.shading.normal, direction));
  const double approach_error =
      second_order(rounding) * (u * (1 + 5 * u) * terms + (a + 0x1p-53 * 22 * largest(n)) * sum(d) + 3 * a) +
      u * approach;
  const double offset = std::abs(surface.offset);
  const double offset_error = u * offset + a + 3 * rounding.written(0) * largest(n) + 0x1p-52 * offset;
  DistanceRange range{0, infinity};
  range.lowest = std::min(t, std::max(0.0, (offset - offset_error) / (approach + approach_error) * (1 - u) - a));
  if (approach > approach_error) {
    range.highest = std::max(t, (offset + offset_error) / (approach - approach_error) * (1 + u) + a);
  }
  return range;
}

DistanceRange distance_range(const TriangleSurface<double>& surface, const Vector<double>& direction, double t,
                             const RoundingUnits& rounding) {
  const ShearedTriangle sheared(surface, direction, rounding);
  const double error = sheared.error(t) * second_order(rounding);
  const auto& [a, b, c] = surface.vertices;
  const double margin = rounding.relative * sheared.largest() + rounding.absolute + sheared.written();
  return within_bounds(t, error, std::min({a[0], b[0], c[0]}) - margin, std::max({a[0], b[0], c[0]}) + margin,
                       direction);
}

}  // namespace pyrasim
