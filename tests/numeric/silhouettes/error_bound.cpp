// SPDX-License-Identifier: Apache-2.0
#include "error_bound.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pyrasim::silhouettes {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

using Triple = std::array<double, 3>;

Triple direction(const Ray& ray) { return {1, ray.y<double>(), ray.z<double>()}; }

/// Of the components of (1, y, z). The 1 is exact.
Triple slope_errors(const Ray& ray, const Rounding& rounding) {
  const auto error = [&](double slope) { return rounding.slope_relative * std::abs(slope) + rounding.slope_absolute; };
  return {0, error(ray.y<double>()), error(ray.z<double>())};
}

}  // namespace

// A length loses lost(1) where it is rounded, a product of two lost(2), a slope lost(0). First-order terms, and the
// squares of what may be large; other terms of second order are covered by a factor 1 + 8u.
SphereBound error_bound(const SphereSurface<double>& sphere, const Ray& ray, const Rounding& rounding) {
  const double u = rounding.relative;
  const double second_order = 1 + 8 * u;
  const Triple d = direction(ray);
  const Triple slopes = slope_errors(ray, rounding);
  const Triple center{sphere.center.x, sphere.center.y, sphere.center.z};
  double along = 0, along_size = 0, along_slopes = 0, length = 0, length_size = 0, length_slopes = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    along += center[k] * d[k];
    along_size += std::abs(center[k] * d[k]);
    along_slopes += std::abs(center[k]) * slopes[k];
    length += d[k] * d[k];
    length_size += std::abs(d[k]);
    length_slopes += 2 * std::abs(d[k]) * slopes[k];
  }
  const double inverse = 1 / length;
  // along = c . d: the centre's rounding, a product's and two sums' are 4u; two products that are rounded, and the
  // centre's components times the slopes.
  const double along_error = second_order * (4 * u * along_size + along_slopes + (2 + length_size) * rounding.lost(1));
  // 1 / d . d: a product and two sums; then the quotient.
  const double length_error = second_order * (length_slopes + 3 * u * length + 2 * rounding.lost(0));
  const double inverse_error =
      inverse * length_error / std::max(length - length_error, 0.0) + u * inverse + rounding.lost(0);
  const double t = along * inverse;
  const double t_error =
      along_error * inverse + (std::abs(along) + along_error) * inverse_error + u * std::abs(t) + rounding.lost(1);
  // p = c - t d, the component of the centre across the ray. An error of t moves it along the ray only, across p, so
  // that it counts in second order; what counts is the rounding of c, of the product and of the difference, and the
  // ray's own error.
  double across = 0, squared_error = 0, t_across = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double p = center[k] - t * d[k];
    const double product = k == 0 ? 0 : u * std::abs(t * d[k]) + rounding.lost(1);
    const double error = second_order * (u * std::abs(center[k]) + rounding.lost(1) + product +
                                         std::abs(t) * slopes[k] + u * std::abs(p));
    across += p * p;
    squared_error += 2 * std::abs(p) * error + std::pow(error + t_error * (std::abs(d[k]) + slopes[k]), 2);
    t_across += 2 * t_error * std::abs(p) * slopes[k];
  }
  // r^2 - p . p: three products, two sums; r^2 as given, and the difference, whose rounding keeps the sign.
  const double difference = sphere.radius_squared - across;
  const double discriminant_error = second_order * (squared_error + t_across + 3 * u * across + 3 * rounding.lost(2) +
                                                    u * sphere.radius_squared + rounding.lost(2)) +
                                    u * std::abs(difference);
  // The outer root, t + sqrt(discriminant / length^2).
  const double discriminant = std::max(difference, 0.0);
  const double square = discriminant * inverse;
  const double square_error =
      discriminant_error * (inverse + inverse_error) + discriminant * inverse_error + u * square + rounding.lost(2);
  const double half_chord = std::sqrt(square);
  const double half_chord_error =
      std::min(square_error / half_chord, std::sqrt(square_error)) * (1 + u) + u * half_chord + rounding.lost(1);
  const double outer = t + half_chord;
  const double outer_error = t_error + half_chord_error + u * outer;
  // The inner one, power / length^2 / outer.
  const double numerator = sphere.power * inverse;
  const double numerator_error = second_order * (u * sphere.power + rounding.lost(2)) * inverse +
                                 sphere.power * inverse_error + u * numerator + rounding.lost(2);
  const double inner = numerator / outer;
  const double inner_error = outer > outer_error
                                 ? second_order * ((numerator_error + inner * outer_error) / (outer - outer_error) +
                                                   u * inner + rounding.lost(1))
                                 : infinity;
  return {discriminant_error, along_error, inner_error};
}

PlaneBound error_bound(const PlaneSurface<double>& plane, const Ray& ray, const Rounding& rounding) {
  const double u = rounding.relative;
  const Triple d = direction(ray);
  const Triple slopes = slope_errors(ray, rounding);
  const auto& normal = plane.shading.normal;
  const Triple n{normal.x, normal.y, normal.z};
  double approach = 0, size = 0, error = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double product = n[k] * d[k];
    approach += product;
    size += std::abs(product);
    error += u * std::abs(product) + rounding.lost(0) * std::abs(d[k]) + std::abs(n[k]) * slopes[k];
  }
  // The compensated sum adds u of the result and 5u^2 of its terms; fixed point rounds two products instead.
  const double approach_error =
      (1 + 8 * u) * (error + 5 * u * u * size + 2 * rounding.lost(0)) + u * std::abs(approach);
  const double offset = std::abs(plane.offset);
  const double offset_error = u * offset + rounding.lost(1);
  const double toward = plane.offset < 0 ? -approach : approach;
  const auto t = [&](double distance, double cosine, double sign) {
    return cosine > 0 ? distance / cosine * (1 + sign * u) + sign * rounding.lost(1) : infinity;
  };
  return {approach_error, t(offset - offset_error, toward + approach_error, -1),
          t(offset + offset_error, toward - approach_error, 1)};
}

// A vertex that the shear has moved, (a_y - y a_x, a_z - z a_x), errs by the rounding of its coordinates, of the slope,
// of the product and of the difference. All triangles that share it err alike.
TriangleBound error_bound(const TriangleSurface<double>& triangle, const std::array<double, 3>& edges, double t,
                          const Ray& ray, const Rounding& rounding) {
  const double u = rounding.relative;
  const double second_order = 1 + 8 * u;
  const Triple d = direction(ray);
  const Triple slopes = slope_errors(ray, rounding);
  std::array<std::array<double, 3>, 3> sheared{}, error{};  // [vertex][axis]; axis 0 is not used
  for (std::size_t vertex = 0; vertex < 3; ++vertex) {
    const auto& a = triangle.vertices[vertex];
    for (std::size_t axis = 1; axis < 3; ++axis) {
      const double moved = a[axis] - d[axis] * a[0];
      sheared[vertex][axis] = std::abs(moved);
      error[vertex][axis] = second_order * (u * (std::abs(a[axis]) + 2 * std::abs(d[axis] * a[0]) + std::abs(moved)) +
                                            a[0] * slopes[axis] + (2 + std::abs(d[axis])) * rounding.lost(1));
    }
  }
  TriangleBound bound{};
  double determinant = 0, determinant_error = 0, weighted = 0;
  double nearest = infinity, furthest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t p = (k + 1) % 3, q = (k + 2) % 3;
    // q_y p_z - q_z p_y has the sign of the sheared vertices' own, unless it is less than lost(2) for each product. A
    // triangle smaller than its root is nothing but error: it may count as missed, or as hit by rays beside it.
    double products = 0;
    for (std::size_t axis = 1; axis < 3; ++axis) {
      const std::size_t other = 3 - axis;
      bound.edges[k] += sheared[q][axis] * error[p][other] + error[q][axis] * (sheared[p][other] + error[p][other]);
      products += sheared[q][axis] * sheared[p][other];
    }
    bound.edges[k] = second_order * bound.edges[k] + 2 * rounding.lost(2);
    const double value_error = bound.edges[k] + 2 * u * second_order * products;
    determinant += edges[k];
    determinant_error += value_error;
    weighted += value_error * std::abs(triangle.vertices[k][0] - t);
    nearest = std::min(nearest, triangle.vertices[k][0]);
    furthest = std::max(furthest, triangle.vertices[k][0]);
  }
  // t is the mean of the vertices' depths weighted by the edge functions, which have the same sign where the triangle
  // counts as hit: whatever they are, it lies between these depths. The determinant is not 0 then, and errors of
  // products and depths add to that.
  const double left = std::max(std::abs(determinant) - determinant_error, 2 * rounding.lost(2));
  const double own =
      second_order * (7 * u * furthest + 2 * rounding.lost(1)) + (left > 0 ? 3 * rounding.lost(3) / left : 0);
  const double mean = std::abs(determinant) > determinant_error ? weighted / left : infinity;
  bound.below_t = std::min(mean, t - nearest) + own;
  bound.above_t = std::min(mean, furthest - t) + own;
  return bound;
}

}  // namespace pyrasim::silhouettes
