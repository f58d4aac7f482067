// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "surface/preparation.h"
#include "surface/quadric_bounds.h"
#include "surface/reading.h"
#include "surface/surface_coordinates.h"

namespace pyrasim {

/// Half-spaces that a quadric may be clipped by.
inline constexpr std::size_t max_clips = 8;

template <class Scalar>
struct QuadricSurface : QuadricSurfaceBase<QuadricSurface, Scalar, max_clips> {
  static constexpr SurfaceTraits traits{.name = "quadric", .default_cost = 9, .extent = Extent::either};
};

class AffineMap;
struct FramedQuadric;

/// The points where xx x^2 + yy y^2 + zz z^2 + xy x y + xz x z + yz y z + x x + y y + z z + constant = 0, as far as all
/// half-spaces have them. Capped it is a solid, where that is 0 at most, closed where it is clipped.
struct Quadric {
  static constexpr std::string_view type = "quadric";
  static constexpr std::array<std::string_view, 3> keys{"coefficients", "clip", "capped"};

  struct Coefficients {
    double xx = 0, yy = 0, zz = 0;
    double xy = 0, xz = 0, yz = 0;
    double x = 0, y = 0, z = 0;
    double constant = 0;
  };
  Coefficients coefficients;
  std::vector<HalfSpace<double>> clip{};  ///< in the world's coordinates
  bool capped = false;

  static Quadric read(const JsonReader& reader, const SceneReading& reading);
  Prepared<QuadricSurface> prepared(const Preparation& preparation) const;
  FramedQuadric transformed(const AffineMap& map) const;
  SurfaceCoordinates coordinates_at(const glm::dvec3& point) const;
  void write_pov(PovWriter& pov) const;
};

}  // namespace pyrasim
