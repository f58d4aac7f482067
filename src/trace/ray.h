// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "numeric/scalar.h"

namespace pyrasim {

/// A view ray: from the centre of projection, which is the origin, along a view vector, with what the tests share.
template <class Scalar>
struct ViewRay {
  Vector<Scalar> direction;
  Vector<Scalar> inverse;                ///< 1 / direction, finite: see below
  Scalar inverse_length_squared;         ///< 1 / direction . direction
  std::array<std::uint8_t, 3> backward;  ///< per axis 1 where the inverse is negative

  explicit ViewRay(const Vector<Scalar>& v)
      : direction(v),
        inverse(finite_inverse(v.x), finite_inverse(v.y), finite_inverse(v.z)),
        inverse_length_squared(Scalar(1) / dot(v, v)),
        backward{is_negative(v.x), is_negative(v.y), is_negative(v.z)} {}

 private:
  /// A zero component counts as a tiny one. Then 0 times the inverse is 0, not NaN, a box that contains the origin's
  /// coordinate (its faces included) is crossed for all t, and any other box is missed.
  static Scalar finite_inverse(Scalar component) {
    using std::abs, std::copysign;  // or those of the number format
    constexpr auto tiny = tiny_component<Scalar>();
    return Scalar(1) / (abs(component) < tiny ? copysign(tiny, component) : component);
  }

  static bool is_negative(Scalar component) {
    using std::signbit;
    return signbit(component);
  }
};

/// The nearest hit so far. `order` as in SurfaceIdentity.
template <class Scalar>
struct Nearest {
  Scalar t;
  std::uint32_t order;

  /// Decision D7: t > 0, the nearest wins, equal distances go to the first in the scene.
  bool improved_by(Scalar candidate, std::uint32_t candidate_order) const {
    return candidate > Scalar(0) && (candidate < t || (candidate == t && candidate_order < order));
  }
};

}  // namespace pyrasim
