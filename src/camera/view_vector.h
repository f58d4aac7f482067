// SPDX-License-Identifier: Apache-2.0
// View vectors: formulas (2) to (5), on integer grid addresses (decision D8).
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>

#include "camera/camera.h"
#include "numeric/round_to_format.h"
#include "raster/grid_point.h"

namespace pyrasim {

/// Maps grid points of one screen to view vectors in observer's coordinates, in units of dx: the screen is at depth 1,
/// and what a ray's parameter t counts is depth. So the scene's scale does not enter, and the other components are the
/// ray's slopes.
///
/// Formula (2), v = v_h + (mu + i d_L) v_mu + (nu + j d_L) v_nu, with (4) and (5) put in and divided by dx, is per
/// component an integer times a constant: y = (N_y steps / 2 - row) dy / (dx steps). The integer has 33 bits at most
/// and is exact. The constant is held in double and the product rounded once to the format, so that a component errs by
/// half a unit of its last place and by double's roundings, 2^-53 of it each: that of dy / dx, which is the same for
/// all rays, and in formats narrower than double the product's.
class ViewVectors {
 public:
  /// `steps`: grid steps along a pixel's side, 2^MAX_LEVEL = 1 / d_MAX of formula (3) for pyramids.
  ViewVectors(const Screen& screen, std::int64_t steps, const NumberFormat& format = {})
      : half_step_y_(screen.dy / screen.dx / static_cast<double>(2 * steps)),
        half_step_z_(screen.dz / screen.dx / static_cast<double>(2 * steps)),
        rows_(screen.rows * steps),
        columns_(screen.columns * steps),
        round_(format) {}

  /// The view vector through `point`: formula (2). Its components are values of the format, held in double.
  glm::dvec3 operator()(GridPoint point) const {
    const std::int64_t up = rows_ - 2 * static_cast<std::int64_t>(point.row);
    const std::int64_t right = 2 * static_cast<std::int64_t>(point.column) - columns_;
    const double y = static_cast<double>(up) * half_step_y_;
    const double z = static_cast<double>(right) * half_step_z_;
    return {1, round_(y), round_(z)};
  }

  /// The point whose view vector is `view_vector`, where the format is double: there all differ.
  GridPoint point_of(const glm::dvec3& view_vector) const {
    const std::int64_t up = std::llrint(view_vector.y / half_step_y_);
    const std::int64_t right = std::llrint(view_vector.z / half_step_z_);
    return {static_cast<std::uint32_t>((rows_ - up) / 2), static_cast<std::uint32_t>((columns_ + right) / 2)};
  }

 private:
  double half_step_y_;  ///< dy d_MAX / (2 dx)
  double half_step_z_;
  std::int64_t rows_;  ///< N_y in grid steps
  std::int64_t columns_;
  RoundToFormat round_;
};

}  // namespace pyrasim
