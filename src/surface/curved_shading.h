// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "surface/lighting.h"

namespace pyrasim {

/// Lambert's cosine law where the outward normal differs from place to place, on the side that the ray meets, as
/// `outward` says. `normal` has any length; where a narrow format has nothing left of it the light is the ambient one.
template <class Scalar>
Scalar lambert_of_curved(const Lighting<Scalar>& lighting, const Vector<Scalar>& normal,
                         const Vector<Scalar>& direction, const Vector<Scalar>& outward) {
  using std::sqrt;  // or that of the number format
  const Scalar length = sqrt(dot(normal, normal));
  if (!(length > Scalar(0))) return lighting.ambient;
  const Scalar side = dot(outward, direction) > Scalar(0) ? -length : length;
  const Scalar cosine = dot(normal, lighting.towards_light) / side;
  return lambert(lighting, std::min(std::max(Scalar(0), cosine), Scalar(1)));
}

template <class Scalar>
Scalar lambert_of_curved(const Lighting<Scalar>& lighting, const Vector<Scalar>& normal,
                         const Vector<Scalar>& direction) {
  return lambert_of_curved(lighting, normal, direction, normal);
}

}  // namespace pyrasim
