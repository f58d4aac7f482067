// SPDX-License-Identifier: Apache-2.0
// The trace tree's result: the area-weighted sum of a pixel's terminal nodes.
#pragma once

#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>

#include "pyramid/cell.h"
#include "pyramid/terminal_color.h"

namespace pyrasim {

/// A pixel's trace tree, summed while it grows. Only terminal nodes carry colour, and a node stands for the area of its
/// cell, 4^-L of the pixel's; so the tree needs no storage of its own: an exact sum and the area covered so far say
/// all. Sums are integers: the order of the nodes does not matter, and the result is rounded once.
class TraceTree {
 public:
  /// A terminal node with a cell of that side.
  void add_terminal_node(std::uint32_t log2_side, const FixedColor& color) {
    for (std::size_t k = 0; k < 3; ++k) sum_[k] += static_cast<Wide>(color[k]) << 2 * log2_side;
    area_ += area(log2_side);
  }

  /// Whether the nodes so far cover the pixel: then the tree is complete.
  bool complete(int max_level) const { return area_ == area(static_cast<std::uint32_t>(max_level)); }

  /// Whether one more node with a cell of that side would complete the tree.
  bool completed_by(std::uint32_t log2_side, int max_level) const {
    return area_ + area(log2_side) == area(static_cast<std::uint32_t>(max_level));
  }

  /// The article's calc_result, rounded once: the float nearest to the mean. Requires complete().
  glm::vec3 result(int max_level) const {
    assert(complete(max_level));
    const int exponent = -(fixed_color_bits + 2 * max_level);
    const auto component = [&](Wide sum) { return std::ldexp(static_cast<float>(sum), exponent); };
    return {component(sum_[0]), component(sum_[1]), component(sum_[2])};
  }

 private:
  /// In squares of the grid.
  static constexpr std::uint64_t area(std::uint32_t log2_side) { return std::uint64_t{1} << 2 * log2_side; }

  /// 62 bits of colour and 2 * 16 bits of area.
  __extension__ using Wide = __int128;
  std::array<Wide, 3> sum_{};
  std::uint64_t area_ = 0;
};

/// The result of a tree that is a single node: a pixel of case 1 or 2.
inline glm::vec3 single_node_result(const FixedColor& color) {
  constexpr float unit = 1.0F / (1LL << fixed_color_bits);
  return {static_cast<float>(color[0]) * unit, static_cast<float>(color[1]) * unit,
          static_cast<float>(color[2]) * unit};
}

}  // namespace pyrasim
