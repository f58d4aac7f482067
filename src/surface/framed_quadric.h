// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "surface/affine_map.h"
#include "surface/clip_box.h"
#include "surface/quadric.h"
#include "surface/quadric_frame.h"

namespace pyrasim {

/// By how much coefficients that are doubles may lie from what the scene says, as sums of magnitudes of those of
/// squares, of coordinates and of none. They are those of q times `divisor`, and about a place.
struct CoefficientSizes {
  double squares = 0;
  double linear = 0;
  double constant = 0;
  double divisor = 1;
  glm::dvec3 about{0, 0, 0};
};

/// A box at any angle, its edges too.
struct QuadrupleEnclosure {
  QuadrupleVector center;
  std::array<QuadrupleVector, 3> half;  ///< from the centre to the middles of three faces
};

/// Any quadric as half-spaces leave it, in its own frame: what affine maps make of surfaces of second order. Mapped
/// about their centres, they lose nothing far from the world's origin.
struct FramedQuadric {
  QuadricFrame frame;
  std::vector<ExactHalfSpace> clip{};  ///< in the world's coordinates
  bool capped = false;                 ///< a solid, where q is 0 at most
  bool convex = false;                 ///< no ray has it before and behind a gap
  std::optional<QuadrupleEnclosure> enclosure{};
  double size = 0;  ///< the largest magnitude of a coordinate that the scene gives of it
  double tilt = 0;  ///< by how much the angle of its axes may lie from what the scene says
  CoefficientSizes written{};

  FramedQuadric transformed(const AffineMap& map) const;
  Prepared<QuadricSurface> prepared(const Preparation& preparation) const;
  void write_pov(PovWriter& pov) const;
};

}  // namespace pyrasim
