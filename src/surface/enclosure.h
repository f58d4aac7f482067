// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "numeric/scalar.h"

namespace pyrasim {

/// A box at any angle about a surface.
template <class Scalar>
struct Enclosure {
  Vector<Scalar> center;
  std::array<Vector<Scalar>, 3> half;  ///< from the centre to the middles of three faces

  template <class Other, class Number>
  Enclosure<Other> mapped(const Number& number) const {
    return {number(center, 1), number(half, 1)};
  }
};

inline std::array<glm::dvec3, 8> corners_of(const Enclosure<double>& enclosure) {
  std::array<glm::dvec3, 8> corners;
  const auto& [a, b, c] = enclosure.half;
  for (std::size_t k = 0; k < 8; ++k) {
    corners[k] = enclosure.center + a * (k % 2 == 0 ? -1.0 : 1.0) + b * (k / 2 % 2 == 0 ? -1.0 : 1.0) +
                 c * (k / 4 == 0 ? -1.0 : 1.0);
  }
  return corners;
}

}  // namespace pyrasim
