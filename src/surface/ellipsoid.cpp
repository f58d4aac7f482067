// SPDX-License-Identifier: Apache-2.0
#include "surface/ellipsoid.h"

#include <algorithm>

#include "numeric/vectors.h"
#include "surface/pov_writer.h"
#include "surface/quadric_frame.h"

namespace pyrasim {

Ellipsoid Ellipsoid::read(const JsonReader& reader, const SceneReading&) {
  return {reader.member("center").vec3(coordinates), reader.member("radii").vec3(lengths)};
}

/// (x / a)^2 + (y / b)^2 + (z / c)^2 = 1 times the square of the smallest radius.
Prepared<EllipsoidSurface> Ellipsoid::prepared(const Preparation& preparation) const {
  const Quadruple smallest = std::min({radii.x, radii.y, radii.z});
  QuadricFrame frame{exactly(center), {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};
  Prepared<EllipsoidSurface> prepared{};
  auto& shape = prepared.surface.shape;
  for (std::size_t k = 0; k < 3; ++k) frame.scales[k] = smallest / radii[static_cast<int>(k)];
  frame.constant = -smallest * smallest;
  shape.form = prepared_form(frame, preparation, largest(center) + largest(radii));
  shape.bounded = shape.convex = true;
  shape.enclosure = enclosure_along_axes(center, radii, preparation.frame);
  return prepared;
}

void Ellipsoid::write_pov(PovWriter& pov) const {
  pov.object("sphere", glm::dvec3(0), 1, "scale", radii, "translate", center);
}

}  // namespace pyrasim
