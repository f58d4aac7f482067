// SPDX-License-Identifier: Apache-2.0
#include "surface/cylinder.h"

#include "surface/pov_writer.h"

namespace pyrasim {

Cylinder Cylinder::read(const JsonReader& reader, const SceneReading&) {
  return {AxisSegment::read(reader), reader.member("radius").number(lengths),
          reader.optional_boolean("capped").value_or(true)};
}

/// x^2 + y^2 = r^2.
Prepared<CylinderSurface> Cylinder::prepared(const Preparation& preparation) const {
  QuadricFrame frame = frame_about(axis);
  frame.scales[2] = frame.signs[2] = 0;
  frame.constant = -static_cast<Quadruple>(radius) * radius;
  return {{{cut_off(frame, axis, radius, capped, preparation)}}, {}};
}

void Cylinder::write_pov(PovWriter& pov) const {
  pov.begin("cylinder");
  pov.add(axis.base, axis.cap, radius);
  if (!capped) pov.add("open");
  pov.end();
}

}  // namespace pyrasim
