// SPDX-License-Identifier: Apache-2.0
// 113 bits, in which scenes are prepared: a sum of products of doubles and what is left when such sums cancel come out
// exact to double's rounding.
#pragma once

#include <array>

#include "numeric/scalar.h"

namespace pyrasim {

__extension__ using Quadruple = __float128;
using QuadrupleVector = std::array<Quadruple, 3>;

inline Quadruple magnitude(Quadruple x) { return x < 0 ? -x : x; }
/// 0 of what is not above 0.
Quadruple square_root(Quadruple square);

inline QuadrupleVector exactly(const glm::dvec3& v) { return {v.x, v.y, v.z}; }
glm::dvec3 rounded(const QuadrupleVector& v);
QuadrupleVector difference(const QuadrupleVector& a, const QuadrupleVector& b);
Quadruple dot(const QuadrupleVector& a, const QuadrupleVector& b);
QuadrupleVector cross(const QuadrupleVector& a, const QuadrupleVector& b);
Quadruple length(const QuadrupleVector& v);
/// Of length 1.
QuadrupleVector unit(const QuadrupleVector& v);

}  // namespace pyrasim
