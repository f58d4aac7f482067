// SPDX-License-Identifier: Apache-2.0
// What every kernel asks of its scalar type: a datapath's number format is a parameter.
#pragma once

#include <glm/vec3.hpp>
#include <limits>

namespace pyrasim {

template <class Scalar>
using Vector = glm::vec<3, Scalar>;

/// The relative spacing of the format just above 1.
template <class Scalar>
constexpr Scalar epsilon() {
  return std::numeric_limits<Scalar>::epsilon();
}

/// The scalar product. What lies across the view, y and z, is summed first, so that the two can be exchanged without
/// changing a bit. (glm::dot refuses scalars that are not IEEE formats.)
template <class Scalar>
constexpr Scalar dot(const Vector<Scalar>& a, const Vector<Scalar>& b) {
  return a.x * b.x + (a.y * b.y + a.z * b.z);
}

template <class Scalar>
constexpr Vector<Scalar> cross(const Vector<Scalar>& a, const Vector<Scalar>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Rounds every component of a vector of doubles to the datapath's format.
template <class Scalar>
Vector<Scalar> to_scalar(const glm::dvec3& v) {
  return {static_cast<Scalar>(v.x), static_cast<Scalar>(v.y), static_cast<Scalar>(v.z)};
}

}  // namespace pyrasim
