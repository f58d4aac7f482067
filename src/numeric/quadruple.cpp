// SPDX-License-Identifier: Apache-2.0
#include "numeric/quadruple.h"

#include <cmath>

namespace pyrasim {

/// Newton's method from double's root: it doubles the digits that are right.
Quadruple square_root(Quadruple square) {
  if (!(square > 0)) return 0;
  Quadruple root = std::sqrt(static_cast<double>(square));
  for (int k = 0; k < 2; ++k) root = (root + square / root) / 2;
  return root;
}

glm::dvec3 rounded(const QuadrupleVector& v) {
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

QuadrupleVector difference(const QuadrupleVector& a, const QuadrupleVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Quadruple dot(const QuadrupleVector& a, const QuadrupleVector& b) { return a[0] * b[0] + (a[1] * b[1] + a[2] * b[2]); }

QuadrupleVector cross(const QuadrupleVector& a, const QuadrupleVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Quadruple length(const QuadrupleVector& v) { return square_root(dot(v, v)); }

QuadrupleVector unit(const QuadrupleVector& v) {
  const Quadruple size = length(v);
  return {v[0] / size, v[1] / size, v[2] / size};
}

}  // namespace pyrasim
