// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "../real.h"
#include "camera/view_vector.h"
#include "scene/scene.h"

namespace pyrasim::silhouettes {

/// The ray along (1, y, z), exactly; and its slopes rounded to double.
class Ray {
 public:
  Ray(const Real& y, const Real& z)
      : y_(y), z_(z), double_y_(static_cast<double>(y)), double_z_(static_cast<double>(z)) {}

  /// Through a point of the screen's grid: formula (2) in units of dx, with the screen's lengths as loaded.
  Ray(const Screen& screen, std::int64_t steps, GridPoint point)
      : Ray(slope(screen.rows * steps - 2 * static_cast<std::int64_t>(point.row), screen.dy, screen.dx, steps),
            slope(2 * static_cast<std::int64_t>(point.column) - screen.columns * steps, screen.dz, screen.dx, steps)) {}

  template <class Number>
  const Number& y() const {
    if constexpr (std::is_same_v<Number, double>) {
      return double_y_;
    } else {
      return y_;
    }
  }
  template <class Number>
  const Number& z() const {
    if constexpr (std::is_same_v<Number, double>) {
      return double_z_;
    } else {
      return z_;
    }
  }

 private:
  /// All factors are integers or doubles: products are exact, and the quotient errs by 2^-512.
  static Real slope(std::int64_t half_steps, double pixel, double dx, std::int64_t steps) {
    return Real(static_cast<double>(half_steps)) * Real(pixel) / (Real(dx) * Real(static_cast<double>(2 * steps)));
  }

  Real y_;
  Real z_;
  double double_y_;
  double double_z_;
};

}  // namespace pyrasim::silhouettes
