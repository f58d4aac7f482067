// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>

#include "surface/affine_map.h"
#include "surface/preparation.h"
#include "surface/quadric_bounds.h"
#include "surface/reading.h"
#include "surface/surface_coordinates.h"

namespace pyrasim {

/// A sphere in the frame of its axes.
template <class Scalar>
struct EllipsoidSurface : QuadricSurfaceBase<EllipsoidSurface, Scalar, 0> {
  static constexpr SurfaceTraits traits{.name = "ellipsoid", .default_cost = 5, .extent = Extent::bounded};
};

/// In a scene file its axes are the world's; a transform may turn them.
struct Ellipsoid {
  static constexpr std::string_view type = "ellipsoid";
  static constexpr std::array<std::string_view, 2> keys{"center", "radii"};

  glm::dvec3 center;
  glm::dvec3 radii;
  std::shared_ptr<const QuadrupleMatrix>
      turned{};  ///< the axes that the radii are along, of length 1; none: the world's

  static Ellipsoid read(const JsonReader& reader, const SceneReading& reading);
  Prepared<EllipsoidSurface> prepared(const Preparation& preparation) const;
  Ellipsoid transformed(const AffineMap& map) const;
  SurfaceCoordinates coordinates_at(const glm::dvec3& point) const;
  void write_pov(PovWriter& pov) const;

  QuadrupleMatrix axes() const { return turned ? *turned : QuadrupleMatrix{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}; }
};

}  // namespace pyrasim
