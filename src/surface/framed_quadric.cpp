// SPDX-License-Identifier: Apache-2.0
#include "surface/framed_quadric.h"

#include <algorithm>
#include <cmath>

#include "numeric/vectors.h"
#include "surface/pov_writer.h"
#include "surface/principal_axes.h"

namespace pyrasim {
namespace {

/// Of numbers of 113 bits: what their rounding may leave of an eigenvalue.
constexpr double negligible = 0x1p-92;

/// The squares' signs times axes scaled, about the frame's centre.
GeneralQuadric about_center(const QuadricFrame& frame, const std::array<QuadrupleVector, 3>& axes) {
  GeneralQuadric q{{}, {}, frame.constant + 2 * frame.linear * frame.shift[2]};
  for (std::size_t k = 0; k < 3; ++k) {
    const Quadruple slope = frame.signs[k] * frame.shift[k] + (k == 2 ? frame.linear : 0);
    q.constant += frame.signs[k] * frame.shift[k] * frame.shift[k];
    for (std::size_t i = 0; i < 3; ++i) {
      q.linear[i] += slope * axes[k][i];
      for (std::size_t j = 0; j < 3; ++j) q.matrix[i][j] += frame.signs[k] * axes[k][i] * axes[k][j];
    }
  }
  return q;
}

std::array<QuadrupleVector, 3> scaled_axes(const QuadricFrame& frame) {
  std::array<QuadrupleVector, 3> axes = frame.axes;
  for (std::size_t k = 0; k < 3; ++k) {
    for (Quadruple& x : axes[k]) x *= frame.scales[k];
  }
  return axes;
}

/// How much larger lengths become at most, and how much smaller.
double largest_stretch(const AffineMap& map) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    QuadrupleVector axis{};
    axis[k] = 1;
    const auto stretched = static_cast<double>(length(map.direction(axis)));
    sum += stretched * stretched;
  }
  return std::sqrt(sum);
}

CoefficientSizes mapped_sizes(const CoefficientSizes& sizes, const AffineMap& map, double shrink, double divisor) {
  return {sizes.squares * shrink * shrink, sizes.linear * shrink, sizes.constant, sizes.divisor * divisor,
          rounded(map.point(exactly(sizes.about)))};
}

}  // namespace

/// Points go by the map, so that q's gradients, and with them its axes, go as normals do.
FramedQuadric FramedQuadric::transformed(const AffineMap& map) const {
  std::array<QuadrupleVector, 3> axes = scaled_axes(frame);
  for (QuadrupleVector& axis : axes) axis = map.normal(axis);
  FramedQuadric mapped = *this;
  const auto [found, divisor] = principal_axes(about_center(frame, axes), negligible);
  mapped.frame = found;
  const QuadrupleVector center = map.point(frame.center);
  for (std::size_t k = 0; k < 3; ++k) mapped.frame.center[k] += center[k];
  for (auto& [normal, offset] : mapped.clip) {
    normal = map.normal(normal);
    offset += dot(normal, map.offset());
  }
  if (enclosure) {
    mapped.enclosure->center = map.point(enclosure->center);
    for (QuadrupleVector& half : mapped.enclosure->half) half = map.direction(half);
  }
  const double stretch = largest_stretch(map);
  mapped.size = mapped_length(stretch * size + largest(rounded(map.offset())));
  mapped.tilt = (tilt + 8 * 0x1p-53) * map.unevenness();
  mapped.written =
      mapped_sizes(written, map, map.unevenness() * std::sqrt(3.0) / stretch, static_cast<double>(divisor));
  return mapped;
}

Prepared<QuadricSurface> FramedQuadric::prepared(const Preparation& preparation) const {
  const glm::dvec3& observer = preparation.frame.position();
  // What the coefficients' own rounding changes, so far from where they are about: of q's gradient, and of q.
  double furthest = largest(rounded(frame.center) - written.about);
  if (enclosure) {
    glm::dvec3 corner = magnitudes(rounded(enclosure->center) - written.about);
    for (const QuadrupleVector& half : enclosure->half) corner += magnitudes(rounded(half));
    furthest = std::max(furthest, largest(corner));
  }
  const double reach = furthest + largest(observer - written.about);
  const double drift = 0x1p-53 * (2 * written.squares * reach + written.linear) / written.divisor;
  const double q_written = drift * reach + 0x1p-53 * written.constant / written.divisor;
  Prepared<QuadricSurface> prepared{};
  auto& shape = prepared.surface.shape;
  shape.form = prepared_form(frame, preparation, size, q_written);
  shape.form.drift = drift;
  shape.form.tilt = tilt;
  for (const auto& [exact, offset] : clip) {
    const glm::dvec3 normal = rounded(exact);
    const double scale = std::ldexp(1.0, -std::ilogb(largest(normal)));
    const Quadruple from_observer = offset - dot(exact, exactly(observer));
    shape.clip[shape.clips++] = {preparation.frame.direction(normal * scale),
                                 static_cast<double>(from_observer * scale)};
  }
  shape.capped = capped;
  shape.convex = convex;
  shape.bounded = enclosure.has_value();
  if (!enclosure) return prepared;
  shape.enclosure.center = preparation.frame.point(rounded(enclosure->center));
  for (std::size_t k = 0; k < 3; ++k) {
    shape.enclosure.half[k] = preparation.frame.direction(rounded(enclosure->half[k]));
  }
  return prepared;
}

/// With coefficients in the world's coordinates.
void FramedQuadric::write_pov(PovWriter& pov) const {
  const auto [m, about, constant] = about_center(frame, scaled_axes(frame));
  QuadrupleVector linear{};
  Quadruple at_origin = constant;
  for (std::size_t i = 0; i < 3; ++i) {
    linear[i] = about[i] - dot(m[i], frame.center);
    at_origin -= frame.center[i] * (about[i] + linear[i]);
  }
  const auto twice = [](Quadruple x) { return static_cast<double>(2 * x); };
  Quadric quadric{{.xx = static_cast<double>(m[0][0]),
                   .yy = static_cast<double>(m[1][1]),
                   .zz = static_cast<double>(m[2][2]),
                   .xy = twice(m[0][1]),
                   .xz = twice(m[0][2]),
                   .yz = twice(m[1][2]),
                   .x = twice(linear[0]),
                   .y = twice(linear[1]),
                   .z = twice(linear[2]),
                   .constant = static_cast<double>(at_origin)},
                  {},
                  capped};
  for (const auto& [normal, offset] : clip) quadric.clip.push_back({rounded(normal), static_cast<double>(offset)});
  quadric.write_pov(pov);
}

}  // namespace pyrasim
