// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <variant>

#include "surface/axial_frame.h"
#include "surface/quadric_bounds.h"
#include "surface/surface_coordinates.h"

namespace pyrasim {

/// A circle in the frame across its axis.
template <class Scalar>
struct CylinderSurface : QuadricSurfaceBase<CylinderSurface, Scalar, 2> {
  static constexpr SurfaceTraits traits{.name = "cylinder", .default_cost = 4, .extent = Extent::bounded};
};

/// Capped it is a solid, else a tube, seen from inside too.
struct Cylinder {
  static constexpr std::string_view type = "cylinder";
  static constexpr std::array<std::string_view, 4> keys{"base", "cap", "radius", "capped"};

  AxisSegment axis;
  double radius;
  bool capped = true;

  static Cylinder read(const JsonReader& reader, const SceneReading& reading);
  Prepared<CylinderSurface> prepared(const Preparation& preparation) const;
  std::variant<Cylinder, FramedQuadric> transformed(const AffineMap& map) const;
  SurfaceCoordinates coordinates_at(const glm::dvec3& point) const;
  void write_pov(PovWriter& pov) const;
};

}  // namespace pyrasim
