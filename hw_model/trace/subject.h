// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "pyramid/classifier.h"
#include "raster/grid_point.h"
#include "raster/sample.h"

namespace pyrasim::hw {

/// What is not numbered.
inline constexpr std::uint64_t no_number = std::numeric_limits<std::uint64_t>::max();
inline constexpr std::uint32_t no_pixel = 0xFFFFFFFFU;
/// The side of what is no cell, but a point.
inline constexpr std::uint32_t no_side = 0xFFFFFFFFU;

/// What something that happens is about: a ray through a point, or a node of a pixel's trace tree on its cell.
struct Subject {
  std::uint64_t ray = no_number;       ///< by order of issue from 0; of a node that is not being split yet, the
                                       ///< one that completed it
  std::uint64_t request = no_number;   ///< the subdivision, by order of issue from 0, that the ray or node comes from;
                                       ///< it is the node itself where that is on its way to be split; none: a corner
  GridPoint point{};                   ///< of a ray; the upper left corner of a node's cell
  std::uint32_t log2_side = no_side;   ///< of a node's cell, as in Cell
  std::uint32_t pixel = no_pixel;      ///< row * columns + column, inside the window; none: the ray completes no pixel
  std::uint32_t object = no_object;    ///< that a ray has hit; none: nothing, or that is not known yet
  std::optional<PyramidCase> which{};  ///< of a terminal node

  bool is_node() const { return log2_side != no_side; }
  friend bool operator==(const Subject&, const Subject&) = default;
};

/// What a message says itself about its subject.
template <class Message>
Subject subject_of(const Message&) {
  return {};
}

}  // namespace pyrasim::hw
