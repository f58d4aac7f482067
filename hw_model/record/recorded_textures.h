// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include "hw_model/record/point_table.h"
#include "hw_model/record/ray_columns.h"

namespace pyrasim::hw {

/// Textures of which nothing is there but what the terminal nodes of one frame took of them.
class RecordedTextures {
 public:
  /// `nodes`: rows of NodeColumns. `objects`: how many of the scene's have a texture.
  RecordedTextures(std::size_t objects, PointTable nodes) : objects_(objects), nodes_(std::move(nodes)) {}

  std::size_t objects() const { return objects_; }
  /// Of a terminal node; those that are not recorded took nothing.
  TextureWork work(const Cell& cell) const {
    const std::uint32_t* row = nodes_.find(cell.corner);
    return row == nullptr ? TextureWork() : NodeColumns::read(row);
  }

 private:
  std::size_t objects_;
  PointTable nodes_;  ///< by their cells' upper left corners: no two are on one
};

}  // namespace pyrasim::hw
