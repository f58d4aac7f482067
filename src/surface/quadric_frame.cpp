// SPDX-License-Identifier: Apache-2.0
#include "surface/quadric_frame.h"

#include <cmath>

#include "numeric/vectors.h"

namespace pyrasim {
glm::dvec3 rounded(const QuadrupleVector& v) {
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

/// Newton's method from double's root: it doubles the digits that are right.
Quadruple square_root(Quadruple square) {
  if (!(square > 0)) return 0;
  Quadruple root = std::sqrt(static_cast<double>(square));
  for (int k = 0; k < 2; ++k) root = (root + square / root) / 2;
  return root;
}

QuadrupleVector exactly(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

Quadruple dot(const QuadrupleVector& a, const QuadrupleVector& b) { return a[0] * b[0] + (a[1] * b[1] + a[2] * b[2]); }

QuadricForm<double> prepared_form(const QuadricFrame& frame, const Preparation& preparation, double size,
                                  double written) {
  const glm::dvec3& observer = preparation.frame.position();
  QuadrupleVector from_center = exactly(observer);
  for (std::size_t k = 0; k < 3; ++k) from_center[k] -= frame.center[k];
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

}  // namespace pyrasim
