// SPDX-License-Identifier: Apache-2.0
// The cells of the screen that pyramids stand on: pixels and their parts, the five further points of a subdivision, and
// the four subpixels.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "raster/grid_point.h"
#include "raster/sample.h"
#include "scene/scene.h"

namespace pyrasim {

/// The deepest MAX_LEVEL. Together with the largest screen it keeps grid addresses within 32 bits.
inline constexpr int max_level_limit = 16;

/// Grid addresses of an N_y x N_z screen at `max_level` fit GridPoint.
constexpr bool addressable(int columns, int rows, int max_level) {
  return (static_cast<std::int64_t>(columns > rows ? columns : rows) << max_level) <= 0xFFFFFFFFLL;
}

/// Corners are numbered 0 upper left, 1 upper right, 2 lower left, 3 lower right; so are the subpixels of a pixel.
using CornerSamples = std::array<Sample, 4>;

/// A square of the screen whose corner rays span a pyramid: a pixel, where log2_side is MAX_LEVEL, or a part of one.
struct Cell {
  GridPoint corner;             ///< upper left
  std::uint32_t log2_side = 0;  ///< the side is 2^log2_side steps of the grid; 0: nothing is finer
};

/// In grid steps.
constexpr std::uint32_t side(const Cell& cell) { return 1U << cell.log2_side; }

/// The grid address of corner `corner`.
constexpr GridPoint corner_of(const Cell& cell, std::size_t corner) {
  return {cell.corner.row + (corner >= 2 ? side(cell) : 0), cell.corner.column + (corner % 2 == 1 ? side(cell) : 0)};
}

/// L: the side is 2^-L of the pixel's. For reports; what works on a cell needs its side.
constexpr std::uint32_t level_of(std::uint32_t log2_side, int max_level) {
  return static_cast<std::uint32_t>(max_level) - log2_side;
}

/// A window's pixel. `row`, `column`: counted inside the window.
constexpr Cell pixel_cell(const PixelWindow& window, std::uint32_t row, std::uint32_t column, int max_level) {
  return {{(static_cast<std::uint32_t>(window.row) + row) << max_level,
           (static_cast<std::uint32_t>(window.column) + column) << max_level},
          static_cast<std::uint32_t>(max_level)};
}

/// The points of a subdivision in the order in which their rays are traced: as soon as the third is known the first
/// subpixel is complete, with the fourth the second, with the fifth the last two.
enum SubdivisionPoint : std::uint8_t { top_middle, left_middle, center, right_middle, bottom_middle };
inline constexpr std::size_t subdivision_rays = 5;
using SubdivisionSamples = std::array<Sample, subdivision_rays>;

/// The grid address of one of the five points of a subdivision. Valid while log2_side > 0.
constexpr GridPoint subdivision_point(const Cell& cell, std::size_t point) {
  constexpr std::array<std::uint32_t, subdivision_rays> down{0, 1, 1, 1, 2};
  constexpr std::array<std::uint32_t, subdivision_rays> right{1, 0, 1, 2, 1};
  const std::uint32_t half = side(cell) / 2;
  return {cell.corner.row + down[point] * half, cell.corner.column + right[point] * half};
}

/// Subpixel `child` (0 to 3) of `parent`.
constexpr Cell subpixel(const Cell& parent, std::size_t child) {
  const std::uint32_t half = side(parent) / 2;
  return {{parent.corner.row + (child >= 2 ? half : 0), parent.corner.column + (child % 2 == 1 ? half : 0)},
          parent.log2_side - 1};
}

/// The corner samples of subpixel `child`, from its parent's corners and the five samples of the subdivision.
constexpr CornerSamples subpixel_corners(const CornerSamples& parent, const SubdivisionSamples& middle,
                                         std::size_t child) {
  switch (child) {
    case 0:
      return {parent[0], middle[top_middle], middle[left_middle], middle[center]};
    case 1:
      return {middle[top_middle], parent[1], middle[center], middle[right_middle]};
    case 2:
      return {middle[left_middle], middle[center], parent[2], middle[bottom_middle]};
    default:
      return {middle[center], middle[right_middle], middle[bottom_middle], parent[3]};
  }
}

}  // namespace pyrasim
