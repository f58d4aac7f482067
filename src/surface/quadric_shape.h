// SPDX-License-Identifier: Apache-2.0
// What all surfaces of second order share: a quadric, what planes leave of it, and whether they close it.
#pragma once

#include <cmath>
#include <cstdint>
#include <utility>

#include "surface/curved_shading.h"
#include "surface/enclosure.h"
#include "surface/half_space.h"
#include "surface/lighting.h"
#include "surface/quadric_form.h"
#include "surface/surface.h"
#include "surface/view_ray.h"

namespace pyrasim {

/// `planes`: so many half-spaces at most.
template <class Scalar, std::size_t planes>
struct QuadricShape {
  QuadricForm<Scalar> form;
  std::array<HalfSpace<Scalar>, planes> clip{};
  std::uint8_t clips = 0;
  bool capped = false;   ///< a solid, q <= 0, closed by flat caps where it is clipped; else what is left of its skin
  bool convex = false;   ///< no ray has it before and behind a gap
  bool bounded = false;  ///< by `enclosure`
  Enclosure<Scalar> enclosure{};

  Scalar intersect(const Vector<Scalar>& direction) const;
  Vector<Scalar> normal(const Vector<Scalar>& direction, Scalar t) const;

  QuadricShape seen_from(const Vector<Scalar>& place) const {
    QuadricShape moved = *this;
    moved.form = form.seen_from(place);
    for (HalfSpace<Scalar>& plane : moved.clip) plane.offset = plane.offset - compensated_dot(plane.normal, place);
    moved.enclosure.center = enclosure.center - place;
    return moved;
  }

  template <class Other, class Number>
  QuadricShape<Other, planes> mapped(const Number& number) const {
    return [&]<std::size_t... k>(std::index_sequence<k...>) {
      return QuadricShape<Other, planes>{
          form.template mapped<Other>(number),
          std::array<HalfSpace<Other>, planes>{clip[k].template mapped<Other>(number)...},
          clips,
          capped,
          convex,
          bounded,
          enclosure.template mapped<Other>(number)};
    }
    (std::make_index_sequence<planes>());
  }

 private:
  Stretch<Scalar> clipped(const Vector<Scalar>& direction) const {
    Stretch<Scalar> stretch;
    for (std::size_t k = 0; k < clips; ++k) stretch.keep(clip[k], direction);
    return stretch;
  }
};

/// Where q is 0 along a ray: at both ends of `between`, which q is negative in, or, `outside`, positive.
template <class Scalar>
struct QuadricRoots {
  Stretch<Scalar> between;
  bool outside = false;

  /// `q` has roots and is no constant. The one of the two that no difference is taken for, and by it the other (Higham,
  /// Accuracy and Stability of Numerical Algorithms, 1.8); where a ray runs along a generator, to where the quadric has
  /// no other point, there is the one alone.
  explicit QuadricRoots(const Quadratic<Scalar>& q) {
    using std::sqrt;  // or that of the number format
    const Scalar root = sqrt(q.discriminant);
    const Scalar h = q.b < Scalar(0) ? root - q.b : -(q.b + root);
    const Scalar inner = h == Scalar(0) ? Scalar(0) : q.c / h;
    if (q.a == Scalar(0)) {
      h > Scalar(0) ? between.keep_from(inner) : between.keep_to(inner);
      return;
    }
    const Scalar outer = h / q.a;
    between = {std::min(inner, outer), std::max(inner, outer)};
    outside = q.a < Scalar(0);
  }
};

/// The smallest t > 0 at which a ray meets the surface, or 0 where there is none. Of an observer on the surface, where
/// one root is 0, that one does not count.
template <class Scalar, std::size_t planes>
Scalar QuadricShape<Scalar, planes>::intersect(const Vector<Scalar>& direction) const {
  const Stretch<Scalar> kept = clipped(direction);
  if (kept.empty() || kept.end <= Scalar(0)) return Scalar(0);
  const Quadratic<Scalar> q = form.along(direction);
  const bool constant = q.a == Scalar(0) && q.b == Scalar(0);
  if (constant || !(q.discriminant >= Scalar(0))) {
    return capped && q.c <= Scalar(0) ? kept.first_end() : Scalar(0);
  }
  const auto [between, outside] = QuadricRoots<Scalar>(q);
  if (!capped) {
    for (const Scalar t : {between.begin, between.end}) {
      if (t > Scalar(0) && kept.holds(t) && t < std::numeric_limits<Scalar>::max()) return t;
    }
    return Scalar(0);
  }
  if (!outside) {
    return Stretch<Scalar>{std::max(between.begin, kept.begin), std::min(between.end, kept.end)}.first_end();
  }
  const Scalar before = Stretch<Scalar>{kept.begin, std::min(between.begin, kept.end)}.first_end();
  return before > Scalar(0) ? before : Stretch<Scalar>{std::max(between.end, kept.begin), kept.end}.first_end();
}

/// Outward at the place that the ray meets at t, of any length: the cap's where the ray meets its plane there.
template <class Scalar, std::size_t planes>
Vector<Scalar> QuadricShape<Scalar, planes>::normal(const Vector<Scalar>& direction, Scalar t) const {
  for (std::size_t k = 0; capped && k < clips; ++k) {
    const Scalar approach = compensated_dot(clip[k].normal, direction);
    if (approach != Scalar(0) && clip[k].offset / approach == t) return clip[k].normal;
  }
  return form.gradient(direction, t);
}

/// A surface of the list whose `shape` is a quadric.
template <template <class> class Surface, class Scalar, std::size_t planes>
struct QuadricSurfaceBase {
  using Terms = const ViewRay<Scalar>&;
  using Shading = NoShading<Scalar>;

  QuadricShape<Scalar, planes> shape;
  SurfaceIdentity identity{};

  Scalar intersect(const ViewRay<Scalar>& ray) const { return shape.intersect(ray.direction); }
  Vector<Scalar> outward(const Shading&, const Vector<Scalar>& direction, Scalar t) const {
    return shape.normal(direction, t);
  }
  Scalar shade(const Shading& shading, const Lighting<Scalar>& lighting, const Vector<Scalar>& direction,
               Scalar t) const {
    return lighting.lit ? lambert_of_curved(lighting, outward(shading, direction, t), direction) : Scalar(1);
  }

  /// The same surface for rays that start at `place` instead of the origin.
  Surface<Scalar> seen_from(const Vector<Scalar>& place) const { return {{shape.seen_from(place), identity}}; }

  template <class Other, class Number>
  Surface<Other> mapped(const Number& number) const {
    return {{shape.template mapped<Other>(number), identity}};
  }
};

}  // namespace pyrasim
