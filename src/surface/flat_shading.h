// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "surface/convert.h"
#include "surface/lighting.h"

namespace pyrasim {

/// Shading of a flat surface takes one of two values, by the side that the ray meets.
template <class Scalar>
struct FlatShading {
  Vector<Scalar> normal;  ///< of any length
  Scalar front;           ///< where the ray runs against the normal
  Scalar back;

  Scalar seen_along(const Vector<Scalar>& direction) const { return dot(normal, direction) < Scalar(0) ? front : back; }
  template <class Other, class Number>
  FlatShading<Other> mapped(const Number& number) const {
    return {number(normal, 0), number(front, 0), number(back, 0)};
  }
};

/// `normal`: of length 1.
inline FlatShading<double> flat_shading(const Vector<double>& normal, const Lighting<double>& lighting) {
  if (!lighting.lit) return {normal, 1, 1};
  const double cosine = dot(normal, lighting.towards_light);
  return {normal, lambert(lighting, std::max(cosine, 0.0)), lambert(lighting, std::max(-cosine, 0.0))};
}

}  // namespace pyrasim
