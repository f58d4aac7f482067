// SPDX-License-Identifier: Apache-2.0
// View vectors: formulas (2) to (5), on integer grid addresses (decision D8).
#pragma once

#include <cstdint>

#include "numeric/scalar.h"
#include "scene/scene.h"

namespace pyrasim {

/// A point of the screen, counted in steps of the grid from the screen's upper left corner.
/// With 2^MAX_LEVEL steps a pixel side, row = mu 2^MAX_LEVEL + i 2^(MAX_LEVEL-L), column likewise with nu and j.
struct GridPoint {
  std::uint32_t row = 0;     ///< downwards
  std::uint32_t column = 0;  ///< to the right
  friend bool operator==(const GridPoint&, const GridPoint&) = default;
};

/// Maps grid points of one screen to view vectors in observer's coordinates. They are not normalised: the screen is at
/// ray parameter t = 1.
///
/// Formula (2), v = v_h + (mu + i d_L) v_mu + (nu + j d_L) v_nu, with (4) and (5) put in, is per component an integer
/// times a constant: y = (N_y steps / 2 - row) dy / steps. The integer is exact, so that a component costs one rounding
/// of the constant, one of the integer where it exceeds the format, and one multiplication.
template <class Scalar>
class ViewVectors {
 public:
  /// `steps`: grid steps along a pixel's side, 2^MAX_LEVEL = 1 / d_MAX of formula (3) for pyramids.
  ViewVectors(const Screen& screen, std::int64_t steps)
      : dx_(static_cast<Scalar>(screen.dx)),
        half_step_y_(static_cast<Scalar>(screen.dy / static_cast<double>(2 * steps))),
        half_step_z_(static_cast<Scalar>(screen.dz / static_cast<double>(2 * steps))),
        rows_(screen.rows * steps),
        columns_(screen.columns * steps) {}

  /// The view vector through `point`: formula (2).
  Vector<Scalar> operator()(GridPoint point) const {
    const std::int64_t up = rows_ - 2 * static_cast<std::int64_t>(point.row);
    const std::int64_t right = 2 * static_cast<std::int64_t>(point.column) - columns_;
    return {dx_, static_cast<Scalar>(up) * half_step_y_, static_cast<Scalar>(right) * half_step_z_};
  }

 private:
  Scalar dx_;
  Scalar half_step_y_;  ///< dy d_MAX / 2
  Scalar half_step_z_;
  std::int64_t rows_;  ///< N_y in grid steps
  std::int64_t columns_;
};

}  // namespace pyrasim
