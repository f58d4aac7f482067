// SPDX-License-Identifier: Apache-2.0
#include "contact.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "../torus_oracle.h"
#include "error_bound.h"
#include "intersect/instanced_triangle.h"
#include "surface/distance_range.h"

namespace pyrasim::silhouettes {
namespace {

/// Of a margin, 0 if it is. A margin in Real is a sum of products of six doubles at most: with coordinates below 2^20
/// it is 0 or more than 2^-400, and Real errs by less than 2^-450. Distances that agree as well are equal.
int sign(double x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }
int sign(const Real& x) {
  const Real nothing(0x1p-400);
  return x > nothing ? 1 : x < -nothing ? -1 : 0;
}

template <class Number>
struct Meeting {
  std::array<Number, 3> margins;
  Number t;
  bool hit;
};

template <class Number>
Meeting<Number> meet(const SphereSurface<double>& sphere, const Number& y, const Number& z) {
  using std::sqrt;
  const Number cx(sphere.center.x), cy(sphere.center.y), cz(sphere.center.z);
  const Number along = cx + cy * y + cz * z;
  const Number inverse = Number(1) / (Number(1) + y * y + z * z);
  const Number t = along * inverse;
  const Number px = cx - t, py = cy - t * y, pz = cz - t * z;
  const Number discriminant = Number(sphere.radius_squared) - (px * px + py * py + pz * pz);
  if (sign(discriminant) < 0 || sign(along) < 0) return {{discriminant, along, 0}, t, false};
  const Number half_chord = sign(discriminant) == 0 ? Number(0) : sqrt(discriminant * inverse);
  return {{discriminant, along, 0}, Number(sphere.power) * inverse / (t + half_chord), true};
}

template <class Number>
Meeting<Number> meet(const PlaneSurface<double>& plane, const Number& y, const Number& z) {
  const auto& n = plane.normal;
  const Number approach = Number(n.x) + Number(n.y) * y + Number(n.z) * z;
  const int side = sign(approach) * sign(plane.offset);
  const Number t = side == 0 ? Number(0) : Number(plane.offset) / approach;
  return {{approach, 0, 0}, t, side > 0};
}

/// Edges are m . (q x p) for the vertices p and q and the direction m, whose component `axis` is the largest.
template <class Number>
Meeting<Number> meet_triangle(const std::array<std::array<Number, 3>, 3>& vertices, const std::array<Number, 3>& m,
                              std::size_t axis) {
  std::array<Number, 3> moved_y, moved_z, edges;
  const std::size_t across = (axis + 1) % 3, upward = (axis + 2) % 3;
  const Number y = m[across] / m[axis], z = m[upward] / m[axis];
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& a = vertices[k];
    moved_y[k] = a[across] - y * a[axis];
    moved_z[k] = a[upward] - z * a[axis];
  }
  bool negative = false, positive = false;
  Number determinant(0), depth(0);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t p = (k + 1) % 3, q = (k + 2) % 3;
    edges[k] = m[axis] * (moved_y[q] * moved_z[p] - moved_z[q] * moved_y[p]);
    negative |= sign(edges[k]) < 0;
    positive |= sign(edges[k]) > 0;
    determinant = determinant + edges[k];
    depth = depth + edges[k] * vertices[k][axis];
  }
  if (sign(determinant) == 0) return {edges, vertices[0][axis] / m[axis], false};
  const Number t = depth / (determinant * m[axis]);
  return {edges, t, negative != positive && sign(t) > 0};
}

template <class Number>
Meeting<Number> meet(const Facet& facet, const Ray& ray) {
  std::array<std::array<Number, 3>, 3> vertices;
  const std::array<Number, 3> d{Number(1), ray.y<Number>(), ray.z<Number>()};
  if (facet.instance == nullptr) {
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t i = 0; i < 3; ++i) vertices[k][i] = Number(facet.triangle.vertices[k][i]);
    }
    return meet_triangle(vertices, d, 0);
  }
  const InstanceSurface<double>& of = *facet.instance;
  std::array<Number, 3> m;
  for (std::size_t i = 0; i < 3; ++i) {
    m[i] = Number(of.rows[i].x) * d[0] + Number(of.rows[i].y) * d[1] + Number(of.rows[i].z) * d[2];
    for (std::size_t k = 0; k < 3; ++k) {
      vertices[k][i] =
          Number(facet.triangle.vertices[k][i]) * Number(of.scale) - Number(of.origin[static_cast<int>(i)]);
    }
  }
  return meet_triangle(vertices, m, shear_axes(of, ray, {}).front());
}

template <class Number>
Meeting<Number> meet(const DiscSurface<double>& disc, const Number& y, const Number& z) {
  const auto& n = disc.normal;
  const Number approach = Number(n.x) + Number(n.y) * y + Number(n.z) * z;
  const int side = sign(approach) * sign(disc.offset);
  const Number t = sign(approach) == 0 ? Number(0) : Number(disc.offset) / approach;
  const Number px = t - Number(disc.center.x), py = t * y - Number(disc.center.y), pz = t * z - Number(disc.center.z);
  const Number room = Number(disc.radius_squared) - (px * px + py * py + pz * pz);
  return {{approach, room, 0}, t, side > 0 && sign(room) >= 0};
}

template <class Number>
Meeting<Number> meet(const BoxSurface<double>& box, const Number& y, const Number& z) {
  Number enter(-0x1p100), leave(0x1p100);
  for (const auto& slab : box.slabs) {
    const Number approach = Number(slab.normal.x) + Number(slab.normal.y) * y + Number(slab.normal.z) * z;
    if (sign(approach) == 0) {
      if (slab.lower > 0 || slab.upper < 0) leave = Number(-0x1p100);
      continue;
    }
    Number first = Number(slab.lower) / approach, last = Number(slab.upper) / approach;
    if (sign(last - first) < 0) std::swap(first, last);
    if (sign(first - enter) > 0) enter = first;
    if (sign(last - leave) < 0) leave = last;
  }
  return {{leave - enter, leave, 0}, enter, sign(leave - enter) >= 0 && sign(enter) > 0};
}

/// A ray as QuadricShape meets it.
template <class Number>
struct QuadricMeeting {
  Number a, b, c, discriminant;
  Number begin{-0x1p100}, end{0x1p100};  ///< what planes leave

  QuadricMeeting(const QuadricView& quadric, const Number& y, const Number& z) : a(0), b(0), c(quadric.form.power) {
    const auto& form = quadric.form;
    std::array<Number, 3> m, o;
    for (std::size_t k = 0; k < 3; ++k) {
      const int axis = static_cast<int>(k);
      m[k] = Number(form.axes[k].x) + Number(form.axes[k].y) * y + Number(form.axes[k].z) * z;
      o[k] = Number(form.origin[axis]);
      a = a + Number(form.signs[axis]) * m[k] * m[k];
      b = b + Number(form.signs[axis]) * m[k] * o[k];
    }
    const Number l(form.linear);
    b = b + l * m[2];
    if (sign(a) * sign(c) > 0) {
      discriminant = -(a * Number(form.constant));
      for (int k = 0; k < 3; ++k) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        const Number moment = o[static_cast<std::size_t>(i)] * m[static_cast<std::size_t>(j)] -
                              o[static_cast<std::size_t>(j)] * m[static_cast<std::size_t>(i)];
        discriminant = discriminant - Number(form.signs[i] * form.signs[j]) * moment * moment;
      }
      const Number across = Number(form.signs[0]) * m[0] * (o[0] * m[2] - o[2] * m[0]) +
                            Number(form.signs[1]) * m[1] * (o[1] * m[2] - o[2] * m[1]);
      discriminant = discriminant + l * (l * m[2] * m[2] + Number(2) * across);
    } else {
      discriminant = b * b - a * c;
    }
    for (const auto& [normal, offset] : quadric.clip) {
      const Number approach = Number(normal.x) + Number(normal.y) * y + Number(normal.z) * z;
      if (sign(approach) == 0) {
        if (offset < 0) end = begin - Number(1);
        continue;
      }
      const Number t = Number(offset) / approach;
      if (sign(approach) > 0 && sign(t - end) < 0) end = t;
      if (sign(approach) < 0 && sign(t - begin) > 0) begin = t;
    }
  }

  /// The ends of what lies ahead, in order: of the skin each by itself, of a solid those of its stretches.
  Meeting<Number> hit(bool capped) const {
    using std::sqrt;
    const Number nowhere(0x1p100);
    Meeting<Number> met{{discriminant, a, b}, sign(a) == 0 ? Number(0) : -b / a, false};
    const auto enter = [&](const Number& first, const Number& last) {
      if (met.hit || sign(last - first) < 0) return;
      for (const Number& t : {first, last}) {
        if (met.hit || sign(t) <= 0 || sign(t - nowhere) >= 0) continue;
        met.hit = true;
        met.t = t;
      }
    };
    const auto later = [&](const Number& t) { return sign(t - begin) > 0 ? t : begin; };
    const auto earlier = [&](const Number& t) { return sign(t - end) < 0 ? t : end; };
    if (sign(discriminant) < 0 || (sign(a) == 0 && sign(b) == 0)) {
      if (capped && sign(c) <= 0) enter(begin, end);
      return met;
    }
    const Number root = sign(discriminant) == 0 ? Number(0) : sqrt(discriminant);
    const Number h = sign(b) < 0 ? root - b : -b - root;
    Number first = sign(h) == 0 ? Number(0) : c / h;
    Number last = sign(a) != 0 ? h / a : sign(b) < 0 ? nowhere : -nowhere;
    if (sign(last - first) < 0) std::swap(first, last);
    if (!capped) {
      for (const Number& t : {first, last}) {
        if (sign(t - begin) >= 0 && sign(t - end) <= 0) enter(t, t);
      }
    } else if (sign(a) >= 0) {
      enter(later(first), earlier(last));
    } else {
      enter(begin, earlier(first));
      enter(later(last), end);
    }
    return met;
  }
};

template <class Number, HasQuadricShape Surface>
Meeting<Number> meet(const Surface& surface, const Number& y, const Number& z) {
  return QuadricMeeting<Number>(QuadricView(surface.shape), y, z).hit(surface.shape.capped);
}

template <class Number>
Meeting<Number> meet(const TorusSurface<double>& torus, const Number& y, const Number& z) {
  const auto triple = [](const Vector<double>& v) {
    return std::array<Number, 3>{Number(v.x), Number(v.y), Number(v.z)};
  };
  const TorusOracle<Number> oracle{triple(torus.center), triple(torus.axis), Number(torus.major), Number(torus.minor)};
  const std::array<Number, 3> direction{Number(1), y, z};
  const auto t = oracle.first_hit(direction);
  return {{oracle.least_distance(direction), 0, 0}, t ? *t : oracle.nearest(direction), t.has_value()};
}

/// Which facets may be hit: those whose vertices' bounds, by the rounding of sheared vertices wider, hold the ray.
/// One that was left out wrongly would be one that cannot explain a difference.
class Nearby {
 public:
  Nearby(const ExactScene& scene, const Ray& ray, const Rounding& rounding)
      : y_(static_cast<float>(ray.y<double>())), z_(static_cast<float>(ray.z<double>())) {
    if (scene.facets().empty()) return;
    reach_ = static_cast<float>(0x1p-20 + 4 * (rounding.relative + rounding.slope_relative) +
                                2 * rounding.slope_absolute + 4 * rounding.lost(1) / scene.nearest_vertex());
  }
  bool operator()(const Facet& facet) const {
    const auto& [lower_y, upper_y, lower_z, upper_z] = facet.extent;
    const float reach = reach_ * facet.doubt;
    return (lower_y <= y_ + reach) & (upper_y >= y_ - reach) & (lower_z <= z_ + reach) & (upper_z >= z_ - reach);
  }

 private:
  float y_, z_;
  float reach_ = 0;
};

}  // namespace

template <class Number>
std::vector<Contact> contacts(const ExactScene& scene, const Ray& ray, const Rounding& rounding) {
  std::vector<Contact> result;
  std::vector<Number> distances;
  const auto add = [&](SurfaceKind kind, const SurfaceIdentity& identity, std::size_t index,
                       const Meeting<Number>& met) {
    Contact contact{kind, static_cast<std::uint32_t>(index), identity, met.hit, {}, 0, 0};
    for (std::size_t k = 0; k < 3; ++k) contact.margins[k] = static_cast<double>(met.margins[k]);
    contact.t = static_cast<double>(met.t);
    result.push_back(contact);
    distances.push_back(met.t);
  };
  const Nearby nearby(scene, ray, rounding);
  for_each_kind([&](auto kind) {
    if constexpr (kind == index_of_kind<TriangleSurface>) {
      for (std::size_t k = 0; k < scene.facets().size(); ++k) {
        const Facet& facet = scene.facets()[k];
        if (nearby(facet)) add(kind_at<kind>, facet.triangle.identity, k, meet<Number>(facet, ray));
      }
    } else if constexpr (kind != index_of_kind<InstanceSurface>) {
      const auto& surfaces = scene.surfaces<kind>();
      for (std::size_t k = 0; k < surfaces.size(); ++k) {
        add(kind_at<kind>, surfaces[k].identity, k, meet(surfaces[k], ray.y<Number>(), ray.z<Number>()));
      }
    }
  });
  std::size_t nearest = result.size();
  for (std::size_t k = 0; k < result.size(); ++k) {
    if (!result[k].hit) continue;
    const int order = nearest == result.size() ? -1 : sign(distances[k] - distances[nearest]);
    if (order < 0 || (order == 0 && result[k].identity.order < result[nearest].identity.order)) nearest = k;
  }
  const Number origin = nearest == result.size() ? Number(0) : distances[nearest];
  for (std::size_t k = 0; k < result.size(); ++k) result[k].behind = static_cast<double>(distances[k] - origin);
  if (nearest != result.size()) std::swap(result.front(), result[nearest]);
  return result;
}

template std::vector<Contact> contacts<double>(const ExactScene&, const Ray&, const Rounding&);
template std::vector<Contact> contacts<Real>(const ExactScene&, const Ray&, const Rounding&);

namespace {

Verdict verdict(const SphereSurface<double>& sphere, const Ray& ray, const Contact& contact, const Rounding& rounding) {
  const SphereBound bound = error_bound(sphere, ray, rounding);
  const auto& [discriminant, along, none] = contact.margins;
  return {discriminant >= -bound.discriminant && along > -bound.along,
          discriminant > bound.discriminant && along > bound.along && contact.t > bound.t,
          {},
          contact.behind - bound.t,
          contact.behind + bound.t,
          0,
          0};
}

Verdict verdict(const PlaneSurface<double>& plane, const Ray& ray, const Contact& contact, const Rounding& rounding) {
  const PlaneBound bound = error_bound(plane, ray, rounding);
  const double toward = plane.offset < 0 ? -contact.margins[0] : contact.margins[0];
  const double nearest_hit = contact.t - contact.behind;
  // The ends of the range are far apart or near t; only then `behind` knows more than they.
  const auto behind = [&](double t) { return contact.hit ? contact.behind + (t - contact.t) : t - nearest_hit; };
  return {toward > -bound.approach, toward > bound.approach, {}, behind(bound.lowest_t), behind(bound.highest_t), 0, 0};
}

Verdict within(const TriangleBound& bound, const Contact& contact) {
  Verdict result{};
  bool may_be_positive = true, may_be_negative = true, may_vanish = true;
  for (std::size_t k = 0; k < 3; ++k) {
    may_be_positive &= contact.margins[k] >= -bound.edges[k];
    may_be_negative &= contact.margins[k] <= bound.edges[k];
    result.near_edge[k] = std::abs(contact.margins[k]) <= bound.edges[k];
    may_vanish &= result.near_edge[k];
  }
  result.possible = !bound.beside && (may_be_positive || may_be_negative);
  result.certain = !may_vanish;
  result.lowest_behind = contact.behind - bound.below_t;
  result.highest_behind = contact.behind + bound.above_t;
  return result;
}

/// By whichever of the instance's axes the datapath shears.
Verdict verdict(const Facet& facet, const Ray& ray, const Contact& contact, const Rounding& rounding) {
  if (facet.instance == nullptr) {
    return within(error_bound(facet.triangle, contact.margins, contact.t, ray, rounding), contact);
  }
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Verdict result{false, true, {}, infinity, -infinity, 0, 0};
  for (const std::size_t axis : shear_axes(*facet.instance, ray, rounding)) {
    const auto bound = error_bound(*facet.instance, facet.triangle, axis, contact.margins, contact.t, ray, rounding);
    if (!bound) return {true, false, {true, true, true}, -infinity, infinity, 0, 0};
    const Verdict one = within(*bound, contact);
    result.possible |= one.possible;
    result.certain &= one.certain;
    for (std::size_t k = 0; k < 3; ++k) result.near_edge[k] |= one.near_edge[k];
    result.lowest_behind = std::min(result.lowest_behind, one.lowest_behind);
    result.highest_behind = std::max(result.highest_behind, one.highest_behind);
  }
  return result;
}

Verdict verdict(const DiscSurface<double>& disc, const Ray& ray, const Contact& contact, const Rounding& rounding) {
  const DiscBound bound = error_bound(disc, contact.t, ray, rounding);
  const double toward = disc.offset < 0 ? -contact.margins[0] : contact.margins[0];
  const double room = contact.margins[1];
  return {toward > -bound.plane.approach && room >= -bound.room,
          toward > bound.plane.approach && room > bound.room,
          {},
          contact.behind + (bound.plane.lowest_t - contact.t),
          contact.behind + (bound.plane.highest_t - contact.t),
          0,
          0};
}

Verdict verdict(const BoxSurface<double>& box, const Ray& ray, const Contact& contact, const Rounding& rounding) {
  const BoxBound bound = error_bound(box, ray, rounding);
  const auto& [inside, leave, none] = contact.margins;
  return {inside >= -(bound.enter + bound.leave) && leave > -bound.leave,
          inside > bound.enter + bound.leave && contact.t > bound.enter,
          {},
          contact.behind - bound.enter,
          contact.behind + bound.enter,
          0,
          0};
}

/// By the ranges of roots and of planes, in the datapath's unit. They are worked out in double, which is one rounding
/// more.
template <HasQuadricShape Surface>
Verdict verdict(const Surface& surface, const Ray& ray, const Contact& contact, const Rounding& rounding) {
  const double factor = std::ldexp(1.0, rounding.exponent);
  const Surface scaled = surface.template mapped<double>(Scaling{rounding.exponent});
  const FirstHitRange first =
      quadric_bound(QuadricView(scaled.shape), contact.margins[0] * factor * factor, ray, rounding);
  const auto behind = [&](double t) { return contact.behind + (t / factor - contact.t); };
  return {first.possible(), first.certain(), {}, behind(first.range().lowest), behind(first.range().highest), 0, 0};
}

/// Likewise, the torus in the datapath's unit.
Verdict verdict(const TorusSurface<double>& torus, const Ray& ray, const Contact& contact, const Rounding& rounding) {
  const double factor = std::ldexp(1.0, rounding.exponent);
  const auto scaled = torus.mapped<double>(Scaling{rounding.exponent});
  const FirstHitRange first = torus_bound(scaled, contact.margins[0] * factor, ray, rounding);
  const auto behind = [&](double t) { return contact.behind + (t / factor - contact.t); };
  return {first.possible(), first.certain(), {}, behind(first.range().lowest), behind(first.range().highest), 0, 0};
}

template <class Surface>
DistanceRange range_of(const PreparedScene<double>&, const Surface& surface, const Scaling& scaling,
                       const Vector<double>& direction, double t, const RoundingUnits& units) {
  return distance_range(surface.template mapped<double>(scaling), direction, t, units);
}
/// A mesh's own numbers are of the size that suits the format.
DistanceRange range_of(const PreparedScene<double>& scene, const Facet& facet, const Scaling& scaling,
                       const Vector<double>& direction, double t, const RoundingUnits& units) {
  if (facet.instance == nullptr) return range_of(scene, facet.triangle, scaling, direction, t, units);
  InstanceSurface<double> instance = facet.instance->mapped<double>(scaling);
  instance.within.margin = 0x1p100;  // that of the format is not known here: boxes tell nothing
  const InstancedTriangle<double> triangle(instance, scene.meshes[instance.mesh], facet.place);
  return triangle.distance_range(direction, t, units);
}

/// The hit errs, and the datapath grants it as much again to either side: the range of twice the rounding. An
/// instance's errors depend on where it is hit, so that its hit may be granted what it is at either end.
template <class Surface>
Verdict with_range(Verdict verdict, const ExactScene& scene, const Surface& surface, const Ray& ray,
                   const Contact& contact, const Rounding& rounding) {
  const double factor = std::ldexp(1.0, rounding.exponent);
  const RoundingUnits units{2 * rounding.relative, 2 * rounding.absolute, scene.place() * factor};
  const Vector<double> direction{1, ray.y<double>(), ray.z<double>()};
  verdict.begins_behind = verdict.lowest_behind;
  verdict.ends_behind = verdict.highest_behind;
  const auto grant = [&](double t) {
    if (!(t > 0) || !std::isfinite(t)) return;
    const DistanceRange range =
        range_of(scene.prepared(), surface, Scaling{rounding.exponent}, direction, t * factor, units);
    verdict.begins_behind = std::min(verdict.begins_behind, contact.behind + (range.lowest / factor - contact.t));
    verdict.ends_behind = std::max(verdict.ends_behind, contact.behind + (range.highest / factor - contact.t));
  };
  grant(contact.t);
  if constexpr (std::is_same_v<Surface, Facet>) {
    if (surface.instance == nullptr) return verdict;
    grant(contact.t + (verdict.lowest_behind - contact.behind));
    grant(contact.t + (verdict.highest_behind - contact.behind));
  }
  return verdict;
}

}  // namespace

Verdict verdict(const ExactScene& scene, const Ray& ray, const Contact& contact, const Rounding& rounding) {
  const auto of = [&](const auto& surface) {
    return with_range(verdict(surface, ray, contact, rounding), scene, surface, ray, contact, rounding);
  };
  return with_kind(contact.kind, [&](auto kind) {
    if constexpr (kind == index_of_kind<TriangleSurface> || kind == index_of_kind<InstanceSurface>) {
      return of(scene.facets()[contact.index]);
    } else {
      return of(scene.surfaces<kind>()[contact.index]);
    }
  });
}

}  // namespace pyrasim::silhouettes
