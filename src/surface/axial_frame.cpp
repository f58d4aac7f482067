// SPDX-License-Identifier: Apache-2.0
#include "surface/axial_frame.h"

#include <fmt/format.h>

#include <algorithm>

#include "numeric/vectors.h"

namespace pyrasim {
namespace {

QuadrupleVector difference(const QuadrupleVector& a, const QuadrupleVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
QuadrupleVector unit(const QuadrupleVector& v) {
  const Quadruple length = square_root(dot(v, v));
  return {v[0] / length, v[1] / length, v[2] / length};
}

}  // namespace

AxisSegment AxisSegment::read(const JsonReader& reader) {
  const AxisSegment axis{reader.member("base").vec3(coordinates), reader.member("cap").vec3(coordinates)};
  if (!(axis.length() >= min_length)) {
    reader.member("cap").fail("it is where base is", fmt::format("a point at least {} away is needed", min_length));
  }
  return axis;
}

Quadruple AxisSegment::length() const {
  const QuadrupleVector along = difference(exactly(cap), exactly(base));
  return square_root(dot(along, along));
}

/// The axis times the world's x is across; any other direction would do as well, but this one stays what it is where a
/// scene is mirrored or transposed.
QuadricFrame frame_about(const AxisSegment& axis) {
  const QuadrupleVector base = exactly(axis.base);
  const QuadrupleVector cap = exactly(axis.cap);
  const QuadrupleVector along = unit(difference(cap, base));
  const bool along_x = along[1] * along[1] + along[2] * along[2] < 0x1p-80;
  const QuadrupleVector across = along_x ? QuadrupleVector{0, 1, 0} : unit({0, along[2], -along[1]});
  const QuadrupleVector other{along[1] * across[2] - along[2] * across[1], along[2] * across[0] - along[0] * across[2],
                              along[0] * across[1] - along[1] * across[0]};
  QuadricFrame frame{{}, {across, other, along}};
  for (std::size_t k = 0; k < 3; ++k) frame.center[k] = (base[k] + cap[k]) / 2;
  return frame;
}

QuadricShape<double, 2> cut_off(const QuadricFrame& frame, const AxisSegment& axis, double radius,
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
  shape.bounded = true;
  shape.enclosure = {preparation.frame.point(rounded(frame.center)),
                     {preparation.frame.direction(rounded(frame.axes[0])) * radius,
                      preparation.frame.direction(rounded(frame.axes[1])) * radius,
                      preparation.frame.direction(along) * (length / 2)}};
  return shape;
}

}  // namespace pyrasim
