// SPDX-License-Identifier: Apache-2.0
#include "surface/axial_frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "numeric/vectors.h"

namespace pyrasim {
AxisSegment AxisSegment::read(const JsonReader& reader) {
  const AxisSegment axis{reader.member("base").vec3(coordinates), reader.member("cap").vec3(coordinates)};
  if (!(axis.length() >= min_length)) {
    reader.member("cap").fail("it is where base is", fmt::format("a point at least {} away is needed", min_length));
  }
  return axis;
}

Quadruple AxisSegment::length() const { return pyrasim::length(difference(exactly(cap), exactly(base))); }

AxisSegment AxisSegment::transformed(const AffineMap& map) const {
  const AxisSegment mapped{mapped_point(map, base), mapped_point(map, cap)};
  static_cast<void>(mapped_length(mapped.length()));
  return mapped;
}

/// The axis times the world's x is across; any other direction would do as well, but this one stays what it is where a
/// scene is mirrored or transposed.
QuadricFrame frame_about(const AxisSegment& axis) {
  const QuadrupleVector base = exactly(axis.base);
  const QuadrupleVector cap = exactly(axis.cap);
  const QuadrupleVector along = unit(difference(cap, base));
  const bool along_x = along[1] * along[1] + along[2] * along[2] < 0x1p-80;
  const QuadrupleVector across = along_x ? QuadrupleVector{0, 1, 0} : unit({0, along[2], -along[1]});
  QuadricFrame frame{{}, {across, cross(along, across), along}};
  for (std::size_t k = 0; k < 3; ++k) frame.center[k] = (base[k] + cap[k]) / 2;
  return frame;
}

FramedQuadric cut_off(const QuadricFrame& frame, const AxisSegment& axis, double radius, bool capped) {
  FramedQuadric result{.frame = frame, .capped = capped, .convex = capped};
  const QuadrupleVector& along = frame.axes[2];
  const QuadrupleVector back{-along[0], -along[1], -along[2]};
  result.clip = {{back, dot(back, exactly(axis.base))}, {along, dot(along, exactly(axis.cap))}};
  result.enclosure = {frame.center, frame.axes};
  const std::array<Quadruple, 3> reach{radius, radius, axis.length() / 2};
  for (std::size_t k = 0; k < 3; ++k) {
    for (Quadruple& x : result.enclosure->half[k]) x *= reach[k];
  }
  result.size = std::max(largest(axis.base), largest(axis.cap)) + radius;
  result.tilt = 0x1p-53 * 2 * result.size / static_cast<double>(axis.length());
  return result;
}

QuadricShape<double, 2> cut_off(const QuadricFrame& frame, const AxisSegment& axis, double radius, bool capped,
                                const Preparation& preparation) {
  const glm::dvec3& observer = preparation.frame.position();
  const double size = std::max(largest(axis.base), largest(axis.cap)) + radius;
  const auto length = static_cast<double>(axis.length());
  const double written = 0x1p-53 * 2 * size;  // of a difference of coordinates
  const glm::dvec3 along = rounded(frame.axes[2]);
  QuadricShape<double, 2> shape{prepared_form(frame, preparation, size)};
  shape.form.tilt = written / length;
  shape.clips = 2;
  for (const bool at_cap : {false, true}) {
    const glm::dvec3 outward = at_cap ? along : -along;
    const Quadruple offset =
        dot(exactly(outward), difference(exactly(at_cap ? axis.cap : axis.base), exactly(observer)));
    shape.clip[at_cap ? 1 : 0] = {preparation.frame.direction(outward), static_cast<double>(offset)};
  }
  shape.capped = shape.convex = capped;
  shape.bounded = true;
  shape.enclosure = {preparation.frame.point(rounded(frame.center)),
                     {preparation.frame.direction(rounded(frame.axes[0])) * radius,
                      preparation.frame.direction(rounded(frame.axes[1])) * radius,
                      preparation.frame.direction(along) * (length / 2)}};
  return shape;
}

SurfaceCoordinates AxisSegment::coordinates_at(const glm::dvec3& point, double base_radius, double cap_radius) const {
  SurfaceCoordinates skin = about_axis(cap - base, base, point);
  const double height = glm::distance(base, cap);
  const glm::dvec3 along = (cap - base) / height;
  const glm::dvec3 from = point - base;
  const double from_axis = glm::length(from - along * glm::dot(along, from));
  const double radius = base_radius + (cap_radius - base_radius) * (skin.v / height);
  // How far the point lies from skin and ends: it is on what it is nearest to.
  const double slope = (cap_radius - base_radius) / height;
  const double from_skin = std::abs(from_axis - radius) / std::sqrt(1 + slope * slope);
  for (const bool at_cap : {false, true}) {
    if (std::abs(skin.v - (at_cap ? height : 0)) >= from_skin) continue;
    SurfaceCoordinates end = on_plane(along, at_cap ? cap : base, point);
    end.chart = at_cap ? 2 : 1;
    return end;
  }
  return skin;
}

}  // namespace pyrasim
