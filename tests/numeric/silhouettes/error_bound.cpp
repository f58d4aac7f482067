// SPDX-License-Identifier: Apache-2.0
#include "error_bound.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "surface/quadric_steps.h"

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

// A length loses lost(1) where it is rounded, a product of two lost(2), a slope lost(0). First-order terms, and the
// squares of what may be large; other terms of second order are covered by a factor 1 + 8u.
double second_order(const Rounding& rounding) { return 1 + 8 * rounding.relative; }

struct Bounded {
  double value;
  double error;
};

/// The steps of SphereSurface::intersect(), each with its error.
class SphereSteps {
 public:
  SphereSteps(const SphereSurface<double>& sphere, const Ray& ray, const Rounding& rounding)
      : sphere_(sphere),
        rounding_(rounding),
        u_(rounding.relative),
        d_(direction(ray)),
        slopes_(slope_errors(ray, rounding)),
        center_{sphere.center.x, sphere.center.y, sphere.center.z} {}

  SphereBound bound() const {
    const Bounded along = along_ray();
    const Bounded inverse = inverse_length_squared();
    const Bounded t = closest(along, inverse);
    const Bounded difference = discriminant(t);
    return {difference.error, along.error, nearer_root(t, difference, inverse).error};
  }

 private:
  /// c . d: the centre's rounding, a product's and two sums' are 4u; two products that are rounded, and the centre's
  /// components times the slopes.
  Bounded along_ray() const {
    Bounded along{0, 2 * rounding_.lost(1)};
    for (std::size_t k = 0; k < 3; ++k) {
      along.value += center_[k] * d_[k];
      along.error += 4 * u_ * std::abs(center_[k] * d_[k]) + std::abs(center_[k]) * slopes_[k] +
                     std::abs(d_[k]) * rounding_.lost(1);
    }
    along.error *= second_order(rounding_);
    return along;
  }

  /// 1 / d . d: a product and two sums; then the quotient.
  Bounded inverse_length_squared() const {
    double length = 0, error = 2 * rounding_.lost(0);
    for (std::size_t k = 0; k < 3; ++k) {
      length += d_[k] * d_[k];
      error += 2 * std::abs(d_[k]) * slopes_[k] + 3 * u_ * d_[k] * d_[k];
    }
    error *= second_order(rounding_);
    return {1 / length, error / length / std::max(length - error, 0.0) + u_ / length + rounding_.lost(0)};
  }

  /// t of the ray's point nearest to the centre.
  Bounded closest(const Bounded& along, const Bounded& inverse) const {
    const double t = along.value * inverse.value;
    return {t, along.error * inverse.value + (std::abs(along.value) + along.error) * inverse.error + u_ * std::abs(t) +
                   rounding_.lost(1)};
  }

  /// r^2 - p . p, where p = c - t d is the centre's component across the ray. An error of t moves p along the ray, at a
  /// right angle to itself: it counts in second order. What counts is the rounding of c, of the product and of the
  /// difference, and the ray's own error.
  Bounded discriminant(const Bounded& t) const {
    double across = 0, error = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double p = center_[k] - t.value * d_[k];
      const double product = k == 0 ? 0 : u_ * std::abs(t.value * d_[k]) + rounding_.lost(1);
      const double p_error = second_order(rounding_) * (u_ * std::abs(center_[k]) + rounding_.lost(1) + product +
                                                        std::abs(t.value) * slopes_[k] + u_ * std::abs(p));
      across += p * p;
      error += 2 * std::abs(p) * (p_error + t.error * slopes_[k]) +
               std::pow(p_error + t.error * (std::abs(d_[k]) + slopes_[k]), 2);
    }
    // Three products and two sums; r^2 as given, and the difference, whose rounding keeps the sign.
    error += 3 * u_ * across + 3 * rounding_.lost(2) + u_ * sphere_.radius_squared + rounding_.lost(2);
    const double difference = sphere_.radius_squared - across;
    return {difference, second_order(rounding_) * error + u_ * std::abs(difference)};
  }

  /// power / length^2 over the outer root, which is t + sqrt(discriminant / length^2).
  Bounded nearer_root(const Bounded& t, const Bounded& difference, const Bounded& inverse) const {
    const double discriminant = std::max(difference.value, 0.0);
    const double square = discriminant * inverse.value;
    const double square_error = difference.error * (inverse.value + inverse.error) + discriminant * inverse.error +
                                u_ * square + rounding_.lost(2);
    const double half_chord = std::sqrt(square);
    const double half_chord_error =
        std::min(square_error / half_chord, std::sqrt(square_error)) * (1 + u_) + u_ * half_chord + rounding_.lost(1);
    const double outer = t.value + half_chord;
    const double outer_error = t.error + half_chord_error + u_ * outer;
    const double numerator = sphere_.power * inverse.value;
    const double numerator_error = second_order(rounding_) * (u_ * sphere_.power + rounding_.lost(2)) * inverse.value +
                                   sphere_.power * inverse.error + u_ * numerator + rounding_.lost(2);
    const double inner = numerator / outer;
    if (!(outer > outer_error)) return {inner, infinity};
    const double quotient_error = (numerator_error + inner * outer_error) / (outer - outer_error);
    return {inner, second_order(rounding_) * (quotient_error + u_ * inner + rounding_.lost(1))};
  }

  const SphereSurface<double>& sphere_;
  Rounding rounding_;
  double u_;
  Triple d_;
  Triple slopes_;
  Triple center_;
};

/// A triangle and a ray as the shear takes them, each number with its error; the axis that it shears along comes first.
struct ShearedNumbers {
  std::array<Triple, 3> vertices{}, errors{};  // [vertex][axis]
  Triple direction{}, slope_errors{};          // (1, y, z)
};

/// A triangle's vertices as the shear moves them, (a_y - y a_x, a_z - z a_x). They err by what is known of coordinates
/// and slope, and by the rounding of the product and of the difference. All triangles that share a vertex have it at
/// one place.
struct ShearedVertices {
  std::array<Triple, 3> size{}, error{};  // [vertex][axis]; axis 0 is not used
  bool beside = false;

  ShearedVertices(const ShearedNumbers& of, const Rounding& rounding) {
    for (std::size_t axis = 1; axis < 3; ++axis) {
      double lowest = infinity, highest = -infinity;
      const double slope = std::abs(of.direction[axis]);
      for (std::size_t k = 0; k < 3; ++k) {
        const auto& a = of.vertices[k];
        const double moved = a[axis] - of.direction[axis] * a[0];
        const double steps = rounding.relative * (slope * std::abs(a[0]) + std::abs(moved)) + rounding.lost(1);
        size[k][axis] = std::abs(moved);
        error[k][axis] = second_order(rounding) * (of.errors[k][axis] + slope * of.errors[k][0] + steps +
                                                   std::abs(a[0]) * of.slope_errors[axis]);
        lowest = std::min(lowest, moved - error[k][axis]);
        highest = std::max(highest, moved + error[k][axis]);
      }
      beside |= lowest > 0 || highest < 0;
    }
  }

  /// q_y p_z - q_z p_y: two products, of which fixed point loses lost(2) each, and their difference. A triangle that is
  /// smaller than the root of that is nothing but error: it may count as missed, or as hit within its bounds.
  double edge_error(std::size_t p, std::size_t q, const Rounding& rounding) const {
    double sum = 0;
    for (std::size_t axis = 1; axis < 3; ++axis) {
      const std::size_t other = 3 - axis;
      sum += size[q][axis] * error[p][other] + error[q][axis] * (size[p][other] + error[p][other]) +
             2 * rounding.relative * size[q][axis] * size[p][other];
    }
    return second_order(rounding) * sum + 2 * rounding.lost(2);
  }
};

}  // namespace

SphereBound error_bound(const SphereSurface<double>& sphere, const Ray& ray, const Rounding& rounding) {
  return SphereSteps(sphere, ray, rounding).bound();
}

PlaneBound plane_bound(const Vector<double>& normal, double plane_offset, const Ray& ray, const Rounding& rounding) {
  const double u = rounding.relative;
  const Triple d = direction(ray);
  const Triple slopes = slope_errors(ray, rounding);
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
      second_order(rounding) * (error + 5 * u * u * size + 2 * rounding.lost(0)) + u * std::abs(approach);
  const double offset = std::abs(plane_offset);
  const double offset_error = u * offset + rounding.lost(1);
  const double toward = plane_offset < 0 ? -approach : approach;
  const auto t = [&](double distance, double cosine, double sign) {
    return cosine > 0 ? distance / cosine * (1 + sign * u) + sign * rounding.lost(1) : infinity;
  };
  return {approach_error, t(offset - offset_error, toward + approach_error, -1),
          t(offset + offset_error, toward - approach_error, 1)};
}

PlaneBound error_bound(const PlaneSurface<double>& plane, const Ray& ray, const Rounding& rounding) {
  return plane_bound(plane.normal, plane.offset, ray, rounding);
}

/// The place errs by the rounding of the centre, of t times the slope and of the difference, and by t's error.
DiscBound error_bound(const DiscSurface<double>& disc, double t, const Ray& ray, const Rounding& rounding) {
  const double u = rounding.relative;
  const PlaneBound plane = plane_bound(disc.normal, disc.offset, ray, rounding);
  const double t_error = std::max(t - plane.lowest_t, plane.highest_t - t);
  if (!(t_error < infinity)) return {plane, infinity};
  const Triple d = direction(ray);
  const Triple slopes = slope_errors(ray, rounding);
  const Triple center{disc.center.x, disc.center.y, disc.center.z};
  double error = 0, squared = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double product = k == 0 ? 0 : u * std::abs(t * d[k]) + rounding.lost(1);
    const double place = t * d[k] - center[k];
    const double place_error =
        second_order(rounding) * (u * std::abs(center[k]) + rounding.lost(1) + product + std::abs(t) * slopes[k] +
                                  t_error * (std::abs(d[k]) + slopes[k]) + u * std::abs(place));
    error += 2 * std::abs(place) * place_error + place_error * place_error;
    squared += place * place;
  }
  error += 3 * u * squared + 3 * rounding.lost(2) + u * disc.radius_squared + rounding.lost(2);
  return {plane, second_order(rounding) * error};
}

namespace {

/// How far t of a slab's face may lie from the exact one; infinite where the ray may be parallel to it.
double face_error(const Vector<double>& normal, double offset, const Ray& ray, const Rounding& rounding) {
  const Triple d = direction(ray);
  const double approach = std::abs(normal.x * d[0] + normal.y * d[1] + normal.z * d[2]);
  const double approach_error = plane_bound(normal, offset, ray, rounding).approach;
  if (!(approach > approach_error)) return infinity;
  const double u = rounding.relative;
  const double t = std::abs(offset) / approach;
  const double offset_error = u * std::abs(offset) + rounding.lost(1);
  return second_order(rounding) *
         ((t * approach_error + offset_error) / (approach - approach_error) + u * t + rounding.lost(1));
}

}  // namespace

/// A ray that may be parallel to a slab within which the observer is does not enter or leave it near the box. Of the
/// others those count that may come last, or first.
BoxBound error_bound(const BoxSurface<double>& box, const Ray& ray, const Rounding& rounding) {
  const Triple d = direction(ray);
  std::array<Bounded, 3> enter{}, leave{};
  double surely_entered = -infinity, surely_left = infinity;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& [normal, lower, upper] = box.slabs[k];
    const double approach = normal.x * d[0] + normal.y * d[1] + normal.z * d[2];
    const double error = std::max(face_error(normal, lower, ray, rounding), face_error(normal, upper, ray, rounding));
    if (error == infinity) {
      const bool within = lower < 0 && upper > 0;
      enter[k] = {-infinity, within ? 0 : infinity};
      leave[k] = {infinity, within ? 0 : infinity};
      continue;
    }
    enter[k] = {std::min(lower / approach, upper / approach), error};
    leave[k] = {std::max(lower / approach, upper / approach), error};
    surely_entered = std::max(surely_entered, enter[k].value - error);
    surely_left = std::min(surely_left, leave[k].value + error);
  }
  BoxBound bound{0, 0};
  for (std::size_t k = 0; k < 3; ++k) {
    if (!(enter[k].value + enter[k].error < surely_entered)) bound.enter = std::max(bound.enter, enter[k].error);
    if (!(leave[k].value - leave[k].error > surely_left)) bound.leave = std::max(bound.leave, leave[k].error);
  }
  return bound;
}

namespace {

/// What a plane leaves of the ray; its t are in the datapath's unit.
void keep(StretchRanges& kept, const HalfSpace<double>& plane, const Ray& ray, const Rounding& rounding) {
  const Triple d = direction(ray);
  const double approach = plane.normal.x * d[0] + plane.normal.y * d[1] + plane.normal.z * d[2];
  const double error = face_error(plane.normal, plane.offset, ray, rounding);
  const auto cut = [](DistanceRange& end, double t, double by, auto nearer) {
    end = {nearer(end.lowest, t - by), nearer(end.highest, t + by)};
  };
  const auto least = [](double a, double b) { return std::min(a, b); };
  const auto most = [](double a, double b) { return std::max(a, b); };
  if (error < infinity) {
    const double t = plane.offset / approach;
    approach > 0 ? cut(kept.end, t, error, least) : cut(kept.begin, t, error, most);
    return;
  }
  // It may be parallel: the plane is passed far away, ahead or behind, if at all.
  const double away = std::abs(plane.offset) /
                      (std::abs(approach) + plane_bound(plane.normal, plane.offset, ray, rounding).approach) / 2;
  if (plane.offset < 0) {
    kept = {{away, infinity}, {-infinity, infinity}};
  } else {
    kept.begin = {kept.begin.lowest, std::max(kept.begin.highest, -away)};
    kept.end = {std::min(kept.end.lowest, away), kept.end.highest};
  }
}

}  // namespace

FirstHitRange quadric_bound(const QuadricView& quadric, double discriminant, const Ray& ray, const Rounding& rounding) {
  const QuadricForm<double>& form = quadric.form;
  const RoundingUnits units{rounding.relative + 0x1p-53, rounding.absolute};
  const double u = units.relative;
  const double a = units.absolute;
  const Triple d = direction(ray);
  const Triple slopes = slope_errors(ray, rounding);
  QuadricErrors errors{};
  for (int k = 0; k < 3; ++k) {
    const auto& axis = form.axes[static_cast<std::size_t>(k)];
    if (form.origin[k] == 0 && axis == glm::dvec3(0)) continue;
    errors.direction[k] = 3 * a;
    for (int j = 0; j < 3; ++j) {
      const auto of = static_cast<std::size_t>(j);
      errors.direction[k] += (4 * u * std::abs(axis[j]) + a) * std::abs(d[of]) + std::abs(axis[j]) * slopes[of];
    }
    errors.origin[k] = u * std::abs(form.origin[k]) + a;
  }
  errors.linear = form.linear == 0 ? 0 : u * std::abs(form.linear) + a;
  errors.constant = form.constant == 0 ? 0 : u * std::abs(form.constant) + a;
  errors.power = form.power == 0 ? 0 : u * std::abs(form.power) + a;
  Rounding in_unit = rounding;
  in_unit.relative = u;
  in_unit.exponent = 0;
  StretchRanges kept;
  for (const HalfSpace<double>& plane : quadric.clip) keep(kept, plane, ray, in_unit);
  QuadricSteps steps(form, {d[0], d[1], d[2]}, errors, units);
  steps.set_discriminant(discriminant);
  return first_hit_range(steps.roots(kept), kept, quadric.capped);
}

/// The slopes' errors move the ray's places by as much times the way there. Where the torus grown or shrunk by that is
/// hit is worked out in double, a few roundings of which are added.
FirstHitRange torus_bound(const TorusSurface<double>& torus, double least, const Ray& ray, const Rounding& rounding) {
  const Triple slopes = slope_errors(ray, rounding);
  const double away = std::sqrt(dot(torus.center, torus.center)) + torus.major + torus.minor;
  const double moved =
      displacement_of_kernel(torus, {rounding.relative, rounding.absolute}) + away * std::hypot(slopes[1], slopes[2]);
  FirstHitRange bound;
  if (least > moved) return bound;
  const Triple d = direction(ray);
  const FirstHitRange first = first_hit_range(torus, {d[0], d[1], d[2]}, moved + 0x1p-48 * away);
  const DistanceRange range = first.possible() ? first.range() : DistanceRange{away / 8, infinity};
  bound.add(range, least < -moved);
  return bound;
}

namespace {

/// Of the edge functions, and of the depth along the shear's axis. `depth` is exact.
TriangleBound sheared_bound(const ShearedNumbers& of, const std::array<double, 3>& edges, double depth,
                            const Rounding& rounding) {
  const ShearedVertices sheared(of, rounding);
  TriangleBound bound{};
  bound.beside = sheared.beside;
  double determinant = 0, determinant_error = 0, weighted = 0, displaced = 0;
  double lowest = infinity, highest = -infinity, furthest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double vertex = of.vertices[k][0];
    bound.edges[k] = sheared.edge_error((k + 1) % 3, (k + 2) % 3, rounding);
    determinant += edges[k];
    determinant_error += bound.edges[k];
    weighted += bound.edges[k] * std::abs(vertex - depth);
    displaced = std::max(displaced, of.errors[k][0]);
    lowest = std::min(lowest, vertex);
    highest = std::max(highest, vertex);
    furthest = std::max(furthest, std::abs(vertex));
  }
  // The depth is the mean of the vertices' weighted by the edge functions, which have the same sign where the triangle
  // counts as hit: whatever they are, it lies between these depths. The determinant is not 0 then. To that come the
  // errors of depths, products, sums and the quotient.
  const double left = std::max(std::abs(determinant) - determinant_error, 2 * rounding.lost(2));
  const double own = second_order(rounding) * (6 * rounding.relative * furthest + displaced + rounding.lost(1)) +
                     (left > 0 ? 3 * rounding.lost(3) / left : 0);
  const double mean = std::abs(determinant) > determinant_error ? weighted / left : infinity;
  bound.below_t = std::min(mean, depth - lowest) + own;
  bound.above_t = std::min(mean, highest - depth) + own;
  return bound;
}

}  // namespace

TriangleBound error_bound(const TriangleSurface<double>& triangle, const std::array<double, 3>& edges, double t,
                          const Ray& ray, const Rounding& rounding) {
  ShearedNumbers numbers{triangle.vertices, {}, direction(ray), slope_errors(ray, rounding)};
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      numbers.errors[k][axis] = rounding.relative * std::abs(triangle.vertices[k][axis]) + rounding.lost(1);
    }
  }
  return sheared_bound(numbers, edges, t, rounding);
}

namespace {

/// The direction in the instance's coordinates: its rows, the products and two sums round, and the slopes err.
struct InstanceDirection {
  Triple value{}, error{};

  InstanceDirection(const InstanceSurface<double>& instance, const Ray& ray, const Rounding& rounding) {
    const Triple d = direction(ray);
    const Triple slopes = slope_errors(ray, rounding);
    for (std::size_t k = 0; k < 3; ++k) {
      error[k] = 3 * rounding.absolute;
      for (std::size_t j = 0; j < 3; ++j) {
        const double row = instance.rows[k][static_cast<int>(j)];
        value[k] += row * d[j];
        error[k] += 4 * rounding.relative * std::abs(row * d[j]) + rounding.absolute * std::abs(d[j]) +
                    std::abs(row) * slopes[j];
      }
      error[k] *= second_order(rounding);
    }
  }
};

}  // namespace

std::vector<std::size_t> shear_axes(const InstanceSurface<double>& instance, const Ray& ray, const Rounding& rounding) {
  const InstanceDirection m(instance, ray, rounding);
  std::vector<std::size_t> axes;
  for (std::size_t k = 0; k < 3; ++k) {
    bool may_be = true;
    for (std::size_t j = 0; j < 3; ++j) {
      may_be = may_be && (j == k || std::abs(m.value[k]) + m.error[k] >= std::abs(m.value[j]) - m.error[j]);
    }
    if (may_be) axes.push_back(k);
  }
  return axes;
}

/// Vertices err by their own rounding in the mesh, by that of their product with the mesh's size, of the observer's
/// place, and of the difference.
std::optional<TriangleBound> error_bound(const InstanceSurface<double>& instance,
                                         const TriangleSurface<double>& triangle, std::size_t axis,
                                         const std::array<double, 3>& edges, double t, const Ray& ray,
                                         const Rounding& rounding) {
  const double u = rounding.relative;
  const InstanceDirection m(instance, ray, rounding);
  const double along = m.value[axis];
  const bool scale_is_there = std::ldexp(instance.scale, rounding.exponent) >= 2 * rounding.absolute;
  if (!scale_is_there || !(m.error[axis] < std::abs(along) / 2)) return std::nullopt;
  const double left = std::abs(along) - m.error[axis];
  ShearedNumbers numbers{};
  std::array<double, 3> sheared_edges{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t from = (axis + i) % 3;
    numbers.direction[i] = m.value[from] / along;
    if (i > 0) {
      const double slope = std::abs(numbers.direction[i]);
      numbers.slope_errors[i] =
          second_order(rounding) * ((m.error[from] + slope * m.error[axis]) / left + 2 * u * slope) +
          rounding.absolute * (1 + std::abs(m.value[from]));
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const double vertex = triangle.vertices[k][from] * instance.scale;
      const double place = instance.origin[static_cast<int>(from)];
      numbers.vertices[k][i] = vertex - place;
      numbers.errors[k][i] =
          second_order(rounding) * (u * (std::abs(vertex) + std::abs(place) + std::abs(vertex - place)) +
                                    rounding.lost(1) * (2 + instance.scale));
    }
    sheared_edges[i] = edges[i] / along;
  }
  TriangleBound bound = sheared_bound(numbers, sheared_edges, t * along, rounding);
  // From the depth to t, by the rounded inverse of the component.
  const double relative = m.error[axis] / left + 2 * u + rounding.absolute * std::abs(along);
  if (along < 0) std::swap(bound.below_t, bound.above_t);
  const double below = bound.below_t / std::abs(along);
  const double above = bound.above_t / std::abs(along);
  bound.below_t = below + relative * std::abs(t) + rounding.lost(1);
  bound.above_t = above + relative * (std::abs(t) + above) + rounding.lost(1);
  for (double& edge : bound.edges) edge *= std::abs(along);
  return bound;
}

}  // namespace pyrasim::silhouettes
