// SPDX-License-Identifier: Apache-2.0
// Normals between those at a triangle's vertices (Phong, Illumination for computer generated pictures, Communications
// of the ACM 18, 1975). They shade; which side of a triangle a ray meets, its own normal says.
#pragma once

#include <array>

#include "numeric/scalar.h"

namespace pyrasim {

template <class Scalar>
using VertexNormals = std::array<Vector<Scalar>, 3>;

/// Where `weights`, whose sum is 1, are those of the vertices. Of any length.
template <class Scalar>
Vector<Scalar> mean_normal(const VertexNormals<Scalar>& normals, const std::array<Scalar, 3>& weights) {
  const auto component = [&](int k) {
    return normals[0][k] * weights[0] + (normals[1][k] * weights[1] + normals[2][k] * weights[2]);
  };
  return {component(0), component(1), component(2)};
}

/// `normal`, or its opposite, on the side of `flat`, the triangle's own; that, where a narrow format tells no side.
template <class Scalar>
Vector<Scalar> on_side_of(const Vector<Scalar>& flat, const Vector<Scalar>& normal) {
  const Scalar side = dot(normal, flat);
  if (side == Scalar(0)) return flat;
  return side < Scalar(0) ? -normal : normal;
}

}  // namespace pyrasim
