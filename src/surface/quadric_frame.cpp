// SPDX-License-Identifier: Apache-2.0
#include "surface/quadric_frame.h"

#include <cmath>

#include "numeric/vectors.h"

namespace pyrasim {

QuadricForm<double> prepared_form(const QuadricFrame& frame, const Preparation& preparation, double size,
                                  double written) {
  const glm::dvec3& observer = preparation.frame.position();
  const QuadrupleVector from_center = difference(exactly(observer), frame.center);
  QuadrupleVector origin{};
  QuadricForm<double> form{};
  Quadruple power =
      frame.constant + 2 * frame.linear * (frame.scales[2] * dot(frame.axes[2], from_center) + frame.shift[2]);
  double steepness = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    origin[k] = frame.scales[k] * dot(frame.axes[k], from_center) + frame.shift[k];
    power += frame.signs[k] * origin[k] * origin[k];
    const auto scale = static_cast<double>(frame.scales[k]);
    form.axes[k] = preparation.frame.direction(rounded(frame.axes[k])) * scale;
    const Quadruple slope = frame.signs[k] * origin[k] + (k == 2 ? frame.linear : 0);
    steepness += std::abs(scale * static_cast<double>(slope));
  }
  const double rounding = 4 * epsilon<double>() * steepness * (size + largest(observer)) + written;
  form.signs = rounded(frame.signs);
  form.origin = rounded(origin);
  form.linear = static_cast<double>(frame.linear);
  form.constant = static_cast<double>(frame.constant);
  form.power = std::abs(static_cast<double>(power)) > rounding ? static_cast<double>(power) : 0;
  form.written = written;
  return form;
}

Enclosure<double> enclosure_along_axes(const glm::dvec3& center, const glm::dvec3& half, const ObserverFrame& frame) {
  Enclosure<double> enclosure{frame.point(center), {}};
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 reach(0);
    reach[axis] = half[axis];
    enclosure.half[static_cast<std::size_t>(axis)] = frame.direction(reach);
  }
  return enclosure;
}

}  // namespace pyrasim
