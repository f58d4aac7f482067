// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "surface/quadric_frame.h"

namespace pyrasim {

/// p . matrix p + 2 linear . p + constant, the matrix symmetric.
struct GeneralQuadric {
  std::array<QuadrupleVector, 3> matrix;
  QuadrupleVector linear;
  Quadruple constant;
};

/// The frame of its principal axes about its centre or vertex, where q is what it was over `divisor`, the largest
/// magnitude of an eigenvalue. Eigenvalues below `negligible` times that count as 0, such a quadric is a cylinder or a
/// paraboloid, and so does a linear term or a constant that rounding the coefficients, to double unless told otherwise,
/// may have left.
struct PrincipalAxes {
  QuadricFrame frame;
  Quadruple divisor;
};
PrincipalAxes principal_axes(const GeneralQuadric& quadric, double negligible = 0x1p-48);

}  // namespace pyrasim
