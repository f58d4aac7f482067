// SPDX-License-Identifier: Apache-2.0
// Quadrics in a frame of their own, where a place p has q(p) = +-x^2 +-y^2 +-z^2 + 2 l z + k: what is 0 on the surface.
#pragma once

#include <array>

#include "numeric/scalar.h"

namespace pyrasim {

/// a t^2 + 2 b t + c: q along a ray.
template <class Scalar>
struct Quadratic {
  Scalar a, b, c;
  Scalar discriminant;  ///< b^2 - a c
};

/// A quadric. Its frame's axes are scaled so that only signs are left of the squares' coefficients, and the longest has
/// length 1: its coordinates are lengths, and no larger than those of the scene.
template <class Scalar>
struct QuadricForm {
  std::array<Vector<Scalar>, 3> axes;  ///< in observer's coordinates; at right angles
  Vector<Scalar> signs;                ///< 1, -1 or 0 of x^2, y^2, z^2
  Vector<Scalar> origin;               ///< where the rays start, in the quadric's frame
  Scalar linear;                       ///< l; other than 0 only where z^2 has no part
  Scalar constant;                     ///< k
  Scalar power;                        ///< q(origin), rounded once: 0 for an observer on the surface
  Scalar tilt;                         ///< likewise the angle of its axes
  Scalar drift;                        ///< likewise its centre
  Scalar written;                      ///< by how much q may lie from what the scene says; for error bounds

  Vector<Scalar> turned(const Vector<Scalar>& v) const { return {dot(axes[0], v), dot(axes[1], v), dot(axes[2], v)}; }
  Quadratic<Scalar> along(const Vector<Scalar>& direction) const;
  /// Half of q's gradient at t, in observer's coordinates.
  Vector<Scalar> gradient(const Vector<Scalar>& direction, Scalar t) const;

  /// The same quadric for rays that start at `place` instead.
  QuadricForm seen_from(const Vector<Scalar>& place) const {
    QuadricForm moved = *this;
    moved.origin = origin + turned(place);
    moved.power = dot(signs * moved.origin, moved.origin) + (Scalar(2) * linear * moved.origin.z + constant);
    return moved;
  }

  template <class Other, class Number>
  QuadricForm<Other> mapped(const Number& number) const {
    return {number(axes, 0),  number(signs, 0), number(origin, 1), number(linear, 1), number(constant, 2),
            number(power, 2), number(tilt, 0),  number(drift, 1),  number(written, 2)};
  }
};

/// Far from the quadric b^2 and a c are large and all but equal, and where both are rounded an outline is lost.
/// Lagrange's identity, (sum o_i m_i)^2 - sum o_i^2 sum m_i^2 = -sum (o_i m_j - o_j m_i)^2, says their difference by
/// what the ray (o, m) has across: the moment o x m, which is o's component across the ray times the length of m. The
/// ray's place along itself has left the sum, as if o had been moved to where the ray comes nearest; no quotient is
/// taken. Between roots of different signs, for an observer inside an ellipsoid, b^2 - a c is a sum of two positive
/// terms.
template <class Scalar>
Quadratic<Scalar> QuadricForm<Scalar>::along(const Vector<Scalar>& direction) const {
  const Vector<Scalar> m = turned(direction);
  const Vector<Scalar> signed_m = signs * m;
  Quadratic<Scalar> q{dot(signed_m, m), dot(signed_m, origin) + linear * m.z, power, Scalar(0)};
  const bool same_signs = (q.a > Scalar(0) && q.c > Scalar(0)) || (q.a < Scalar(0) && q.c < Scalar(0));
  if (!same_signs) {
    q.discriminant = q.b * q.b - q.a * q.c;
    return q;
  }
  const Vector<Scalar> moment = cross(origin, m);
  const Vector<Scalar> pairs{signs.y * signs.z, signs.x * signs.z, signs.x * signs.y};
  q.discriminant = -(dot(pairs * moment, moment) + q.a * constant);
  if (linear != Scalar(0)) {
    const Scalar across = signed_m.y * moment.x - signed_m.x * moment.y;
    q.discriminant = q.discriminant + linear * (linear * (m.z * m.z) + Scalar(2) * across);
  }
  return q;
}

template <class Scalar>
Vector<Scalar> QuadricForm<Scalar>::gradient(const Vector<Scalar>& direction, Scalar t) const {
  const Vector<Scalar> place = origin + turned(direction) * t;
  const Vector<Scalar> g = signs * place + Vector<Scalar>(Scalar(0), Scalar(0), linear);
  return axes[0] * g.x + (axes[1] * g.y + axes[2] * g.z);
}

}  // namespace pyrasim
