// SPDX-License-Identifier: Apache-2.0
#include "surface/cylinder.h"

#include "surface/pov_writer.h"

namespace pyrasim {
namespace {

/// x^2 + y^2 = r^2.
QuadricFrame frame_of(const Cylinder& cylinder) {
  QuadricFrame frame = frame_about(cylinder.axis);
  frame.scales[2] = frame.signs[2] = 0;
  frame.constant = -static_cast<Quadruple>(cylinder.radius) * cylinder.radius;
  return frame;
}

}  // namespace

Cylinder Cylinder::read(const JsonReader& reader, const SceneReading&) {
  return {AxisSegment::read(reader), reader.member("radius").number(lengths),
          reader.optional_boolean("capped").value_or(true)};
}

Prepared<CylinderSurface> Cylinder::prepared(const Preparation& preparation) const {
  return {{{cut_off(frame_of(*this), axis, radius, capped, preparation)}}, {}};
}

std::variant<Cylinder, FramedQuadric> Cylinder::transformed(const AffineMap& map) const {
  if (const auto factor = map.similarity())
    return Cylinder{axis.transformed(map), mapped_length(*factor * radius), capped};
  return cut_off(frame_of(*this), axis, radius, capped).transformed(map);
}

void Cylinder::write_pov(PovWriter& pov) const {
  pov.begin("cylinder");
  pov.add(axis.base, axis.cap, radius);
  if (!capped) pov.add("open");
  pov.end();
}

/// Ends have charts of their own, of lengths from the axis on.
SurfaceCoordinates Cylinder::coordinates_at(const glm::dvec3& point) const {
  return axis.coordinates_at(point, radius, radius);
}

}  // namespace pyrasim
