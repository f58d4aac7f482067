// SPDX-License-Identifier: Apache-2.0
// Quadrics as preparation knows them: in the world's coordinates, in 113 bits.
#pragma once

#include "numeric/quadruple.h"
#include "surface/preparation.h"
#include "surface/quadric_shape.h"

namespace pyrasim {

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

/// The box along the world's axes that reaches so far from its centre, seen by the observer.
Enclosure<double> enclosure_along_axes(const glm::dvec3& center, const glm::dvec3& half, const ObserverFrame& frame);

}  // namespace pyrasim
