// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "pyramid/classifier.h"
#include "scene/scene.h"

namespace pyrasim::silhouettes {

/// Visits the pyramids of a frame as the method does: visit(corners, samples) for each pixel, and for each subpixel of
/// an edge down to `max_level`. `sample(point)` is what the ray through a point of the grid brings back.
template <class Sampler, class Visitor>
class FramePyramids {
 public:
  FramePyramids(int max_level, Sampler sample, Visitor visit) : max_level_(max_level), sample_(sample), visit_(visit) {}

  void visit_all(const Screen& screen) {
    for (std::uint32_t row = 0; row < static_cast<std::uint32_t>(screen.rows); ++row) {
      for (std::uint32_t column = 0; column < static_cast<std::uint32_t>(screen.columns); ++column) {
        visit(pixel_cell({}, row, column, max_level_));
      }
    }
  }

 private:
  void visit(const Cell& cell) {
    const std::uint32_t far = side(cell);
    const auto [row, column] = cell.corner;
    const std::array<GridPoint, 4> corners{GridPoint{row, column}, GridPoint{row, column + far},
                                           GridPoint{row + far, column}, GridPoint{row + far, column + far}};
    CornerSamples samples;
    for (std::size_t k = 0; k < 4; ++k) samples[k] = sample_(corners[k]);
    visit_(corners, samples);
    if (!subdivides(classify(samples), cell)) return;
    for (std::size_t child = 0; child < 4; ++child) visit(subpixel(cell, child));
  }

  int max_level_;
  Sampler sample_;
  Visitor visit_;
};

}  // namespace pyrasim::silhouettes
