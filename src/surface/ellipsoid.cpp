// SPDX-License-Identifier: Apache-2.0
#include "surface/ellipsoid.h"

#include <algorithm>

#include "numeric/vectors.h"
#include "surface/pov_writer.h"
#include "surface/principal_axes.h"
#include "surface/quadric_frame.h"

namespace pyrasim {
namespace {

struct Radii {
  QuadrupleMatrix axes;
  QuadrupleVector lengths;
};

/// Those of what `map` makes of it: the mapped ones as they are, where they stay at right angles.
Radii principal_radii(const Ellipsoid& ellipsoid, const AffineMap& map) {
  const QuadrupleMatrix axes = ellipsoid.axes();
  Radii found{axes, {}};
  QuadrupleMatrix normals{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double radius = ellipsoid.radii[static_cast<int>(k)];
    const QuadrupleVector mapped = map.direction(axes[k]);
    found.axes[k] = unit(mapped);
    found.lengths[k] = radius * length(mapped);
    normals[k] = map.normal(axes[k]);
    for (Quadruple& x : normals[k]) x /= radius;
  }
  const auto askew = [&](std::size_t i, std::size_t j) { return magnitude(dot(found.axes[i], found.axes[j])); };
  if (std::max({askew(0, 1), askew(0, 2), askew(1, 2)}) < 0x1p-100) return found;
  GeneralQuadric quadric{{}, {}, -1};  // where the sum of squares of normal . (p - centre) is 1
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (const QuadrupleVector& normal : normals) quadric.matrix[i][j] += normal[i] * normal[j];
    }
  }
  const QuadricFrame frame = principal_axes(quadric, 0x1p-92).frame;
  for (std::size_t k = 0; k < 3; ++k) found.lengths[k] = square_root(-frame.constant) / frame.scales[k];
  found.axes = frame.axes;
  return found;
}

}  // namespace

Ellipsoid Ellipsoid::read(const JsonReader& reader, const SceneReading&) {
  return {reader.member("center").vec3(coordinates), reader.member("radii").vec3(lengths)};
}

/// (x / a)^2 + (y / b)^2 + (z / c)^2 = 1 times the square of the smallest radius.
Prepared<EllipsoidSurface> Ellipsoid::prepared(const Preparation& preparation) const {
  const Quadruple smallest = std::min({radii.x, radii.y, radii.z});
  const QuadrupleMatrix along = axes();
  QuadricFrame frame{exactly(center), along};
  Prepared<EllipsoidSurface> prepared{};
  auto& shape = prepared.surface.shape;
  for (std::size_t k = 0; k < 3; ++k) frame.scales[k] = smallest / radii[static_cast<int>(k)];
  frame.constant = -smallest * smallest;
  shape.form = prepared_form(frame, preparation, largest(center) + largest(radii));
  shape.bounded = shape.convex = true;
  shape.enclosure.center = preparation.frame.point(center);
  for (std::size_t k = 0; k < 3; ++k) {
    shape.enclosure.half[k] = preparation.frame.direction(rounded(along[k]) * radii[static_cast<int>(k)]);
  }
  return prepared;
}

Ellipsoid Ellipsoid::transformed(const AffineMap& map) const {
  const Radii found = principal_radii(*this, map);
  Ellipsoid mapped{mapped_point(map, center), {}, std::make_shared<const QuadrupleMatrix>(found.axes)};
  for (std::size_t k = 0; k < 3; ++k) mapped.radii[static_cast<int>(k)] = mapped_length(found.lengths[k]);
  return mapped;
}

void Ellipsoid::write_pov(PovWriter& pov) const {
  pov.begin("sphere");
  pov.add(glm::dvec3(0), 1, "scale", radii);
  const QuadrupleMatrix along = axes();
  pov.matrix({rounded(along[0]), rounded(along[1]), rounded(along[2])}, center);
  pov.end();
}

/// Those of the unit sphere that it is mapped from.
SurfaceCoordinates Ellipsoid::coordinates_at(const glm::dvec3& point) const {
  return on_sphere((point - center) / radii);
}

}  // namespace pyrasim
