// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "intersect/surface.h"

namespace pyrasim {

/// The smallest t > 0 at which the view ray t * direction meets the sphere, or 0 where there is none.
/// `inverse_length_squared` = 1 / direction . direction, shared by all spheres of a ray.
///
/// From outside the discriminant comes from the component of the centre perpendicular to the ray (Haines, Günther,
/// Akenine-Möller, Ray Tracing Gems, chapter 7): far and small spheres keep their outline where b^2 - 4ac would lose
/// it. For an observer inside the sphere or on it b^2 - 4ac is a sum of two positive terms: no ray of his misses it. On
/// it c, the power, is 0, and so is one root: he does not see the place that he stands on. The roots come from the sum
/// that does not cancel, and from their product.
template <class Scalar>
Scalar intersect_sphere(const SphereSurface<Scalar>& sphere, const Vector<Scalar>& direction,
                        Scalar inverse_length_squared) {
  const Scalar along = dot(sphere.center, direction);
  if (along <= Scalar(0) && sphere.power >= Scalar(0)) return Scalar(0);  // it lies behind, or he looks away from it
  const Scalar t_closest = along * inverse_length_squared;
  Scalar discriminant{};  // over 4 direction . direction
  if (sphere.power > Scalar(0)) {
    const Vector<Scalar> perpendicular{sphere.center.x - t_closest * direction.x,
                                       sphere.center.y - t_closest * direction.y,
                                       sphere.center.z - t_closest * direction.z};
    discriminant = sphere.radius_squared - dot(perpendicular, perpendicular);
    if (!(discriminant >= Scalar(0))) return Scalar(0);
  } else {
    discriminant = along * t_closest - sphere.power;
  }
  using std::sqrt;  // or that of the number format
  const Scalar half_chord = sqrt(discriminant * inverse_length_squared);
  const Scalar t_outer = along < Scalar(0) ? t_closest - half_chord : t_closest + half_chord;  // the larger |t|
  if (t_outer == Scalar(0)) return Scalar(0);
  const Scalar t_inner = sphere.power * inverse_length_squared / t_outer;  // product of roots = power / length^2
  if (t_inner > Scalar(0)) return t_inner;  // from outside the nearer root; from inside the only one ahead
  return t_outer > Scalar(0) ? t_outer : Scalar(0);
}

}  // namespace pyrasim
