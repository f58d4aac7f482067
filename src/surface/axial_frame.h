// SPDX-License-Identifier: Apache-2.0
// What cylinders and cones share: an axis between two points, flat ends, and quadrics that are round about it.
#pragma once

#include "surface/framed_quadric.h"
#include "surface/quadric_frame.h"
#include "surface/reading.h"
#include "surface/surface_coordinates.h"

namespace pyrasim {

/// From the middle of `base` at one end to the middle of `cap` at the other.
struct AxisSegment {
  glm::dvec3 base;
  glm::dvec3 cap;

  /// Members "base" and "cap". Throws InputError.
  static AxisSegment read(const JsonReader& reader);
  Quadruple length() const;
  /// Throws MapError.
  AxisSegment transformed(const AffineMap& map) const;
  /// On a surface round about it, `base_radius` wide at the base and `cap_radius` at the cap: those of about_axis() on
  /// its skin, on its ends those of a plane from the axis on.
  SurfaceCoordinates coordinates_at(const glm::dvec3& point, double base_radius, double cap_radius) const;
};

/// About the middle of the axis, its third one along it; scales, signs and what follows are the caller's.
QuadricFrame frame_about(const AxisSegment& axis);

/// Cut off at both ends, which are closed where it is `capped`, and seen by the observer. `radius`: the largest.
QuadricShape<double, 2> cut_off(const QuadricFrame& frame, const AxisSegment& axis, double radius, bool capped,
                                const Preparation& preparation);

/// The same in the world's coordinates.
FramedQuadric cut_off(const QuadricFrame& frame, const AxisSegment& axis, double radius, bool capped);

}  // namespace pyrasim
