// SPDX-License-Identifier: Apache-2.0
#include "surface/cone.h"

#include <fmt/format.h>

#include <algorithm>

#include "surface/pov_writer.h"

namespace pyrasim {
namespace {

double read_radius(const JsonReader& reader) {
  const double radius = reader.number({0, max_coordinate});
  if (radius > 0 && radius < min_length) {
    reader.fail(fmt::format("{} is too small", radius), fmt::format("0 or at least {} is allowed", min_length));
  }
  return radius;
}

/// w = mean radius + slope * height, from the middle: about the apex a cone that is nearly a cylinder would be far
/// away. Where the slope is more than 1, its axis has the length of 1.
QuadricFrame frame_of(const Cone& cone) {
  const auto& [axis, base_radius, cap_radius, capped] = cone;
  QuadricFrame frame = frame_about(axis);
  const Quadruple slope = (static_cast<Quadruple>(cap_radius) - base_radius) / axis.length();
  const Quadruple steep = magnitude(slope);
  const Quadruple scale = steep > 1 ? 1 / steep : 1;
  frame.scales = {scale, scale, scale * slope};
  frame.signs = {1, 1, -1};
  frame.shift[2] = scale * ((static_cast<Quadruple>(base_radius) + cap_radius) / 2);
  return frame;
}

}  // namespace

Cone Cone::read(const JsonReader& reader, const SceneReading&) {
  const Cone cone{AxisSegment::read(reader), read_radius(reader.member("base_radius")),
                  read_radius(reader.member("cap_radius")), reader.optional_boolean("capped").value_or(true)};
  if (cone.base_radius == 0 && cone.cap_radius == 0) {
    reader.member("cap_radius").fail("it is 0, and so is base_radius", "one of the two may be 0");
  }
  return cone;
}

Prepared<ConeSurface> Cone::prepared(const Preparation& preparation) const {
  return {{{cut_off(frame_of(*this), axis, std::max(base_radius, cap_radius), capped, preparation)}}, {}};
}

std::variant<Cone, FramedQuadric> Cone::transformed(const AffineMap& map) const {
  const auto factor = map.similarity();
  if (!factor) return cut_off(frame_of(*this), axis, std::max(base_radius, cap_radius), capped).transformed(map);
  const auto mapped = [&](double radius) { return radius == 0 ? 0 : mapped_length(*factor * radius); };
  return Cone{axis.transformed(map), mapped(base_radius), mapped(cap_radius), capped};
}

void Cone::write_pov(PovWriter& pov) const {
  pov.begin("cone");
  pov.add(axis.base, base_radius, axis.cap, cap_radius);
  if (!capped) pov.add("open");
  pov.end();
}

SurfaceCoordinates Cone::coordinates_at(const glm::dvec3& point) const {
  return axis.coordinates_at(point, base_radius, cap_radius);
}

}  // namespace pyrasim
