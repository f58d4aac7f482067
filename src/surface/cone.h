// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <variant>

#include "surface/axial_frame.h"
#include "surface/quadric_bounds.h"
#include "surface/surface_coordinates.h"

namespace pyrasim {

/// x^2 + y^2 = w^2, where w is the radius at the place's height.
template <class Scalar>
struct ConeSurface : QuadricSurfaceBase<ConeSurface, Scalar, 2> {
  static constexpr SurfaceTraits traits{.name = "cone", .default_cost = 5, .extent = Extent::bounded};
};

/// From one circle to another; one of the radii may be 0. Capped it is a solid, else a skin, seen from inside too.
struct Cone {
  static constexpr std::string_view type = "cone";
  static constexpr std::array<std::string_view, 5> keys{"base", "cap", "base_radius", "cap_radius", "capped"};

  AxisSegment axis;
  double base_radius;
  double cap_radius;
  bool capped = true;

  static Cone read(const JsonReader& reader, const SceneReading& reading);
  Prepared<ConeSurface> prepared(const Preparation& preparation) const;
  std::variant<Cone, FramedQuadric> transformed(const AffineMap& map) const;
  SurfaceCoordinates coordinates_at(const glm::dvec3& point) const;
  void write_pov(PovWriter& pov) const;
};

}  // namespace pyrasim
