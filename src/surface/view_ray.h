// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "numeric/scalar.h"

namespace pyrasim {

/// A view ray: from the centre of projection, which is the origin, along a view vector, with what the tests share.
template <class Scalar>
struct ViewRay {
  Vector<Scalar> direction;
  Scalar slope_y;  ///< y / x: the same all along the ray; meaningful where x > 0
  Scalar slope_z;
  Scalar inverse_length_squared;  ///< 1 / direction . direction

  explicit ViewRay(const Vector<Scalar>& v) : direction(v), inverse_length_squared(Scalar(1) / dot(v, v)) {
    const Scalar inverse_x = Scalar(1) / v.x;
    slope_y = v.y * inverse_x;
    slope_z = v.z * inverse_x;
  }
};

}  // namespace pyrasim
