// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "camera/camera.h"
#include "hw_model/record/work_table.h"
#include "raster/grid_point.h"

namespace pyrasim::hw {

/// Rows of a WorkTable whose first two numbers are a grid point, found by that. They lie pixel by pixel, as a frame
/// asks for them.
class PointTable {
 public:
  /// Of a frame of `max_level`; rows of points outside of its window are left out, and of equal points all but one.
  PointTable(const WorkTable& rows, const PixelWindow& window, int max_level);

  /// The row of `point`; null where there is none.
  const std::uint32_t* find(GridPoint point) const;

 private:
  static GridPoint point_of(const std::uint32_t* row) { return {row[0], row[1]}; }
  /// The number of the pixel that the point is the upper left corner of, or lies in; the window's right and lower
  /// border belong to pixels of their own. Behind the last one for points outside.
  std::size_t pixel_of(GridPoint point) const;
  /// Adds a pixel's rows; of equal points one.
  void add_sorted(std::span<const std::uint32_t*> rows);

  unsigned log2_steps_;
  GridPoint first_;  ///< the window's upper left pixel
  std::uint32_t rows_;
  std::uint32_t columns_;
  std::vector<std::uint32_t> begin_;  ///< of each pixel's rows in table_; then their end
  WorkTable table_;                   ///< by pixel, and in there by row and column
};

}  // namespace pyrasim::hw
