// SPDX-License-Identifier: Apache-2.0
// Quadrics as preparation knows them: in the world's coordinates, in 113 bits.
#pragma once

#include "surface/preparation.h"
#include "surface/quadric_shape.h"

namespace pyrasim {

using QuadrupleVector = std::array<Quadruple, 3>;

glm::dvec3 rounded(const QuadrupleVector& v);
Quadruple square_root(Quadruple square);
QuadrupleVector exactly(const glm::dvec3& v);
Quadruple dot(const QuadrupleVector& a, const QuadrupleVector& b);

/// The frame in which a quadric is a QuadricForm.
struct QuadricFrame {
  QuadrupleVector center;
  std::array<QuadrupleVector, 3> axes;  ///< at right angles, of length 1
  QuadrupleVector scales{1, 1, 1};      ///< of the axes; 0 where the quadric is the same all along
  QuadrupleVector signs{1, 1, 1};
  Quadruple linear = 0;
  Quadruple constant = 0;
  QuadrupleVector shift{0, 0, 0};  ///< the frame's origin is so far from the centre, in the frame
};

/// Seen by the observer. `size`: the largest magnitude of a coordinate that the scene gives of the quadric; what its
/// rounding may amount to is on the surface. `written`: by how much q may lie from what the scene says beside that.
QuadricForm<double> prepared_form(const QuadricFrame& frame, const Preparation& preparation, double size,
                                  double written = 0);

}  // namespace pyrasim
