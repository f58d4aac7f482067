// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include "hw_model/record/point_index.h"
#include "hw_model/record/ray_columns.h"
#include "hw_model/record/work_table.h"

namespace pyrasim::hw {

/// Textures of which nothing is there but what the terminal nodes of one frame took of them.
class RecordedTextures {
 public:
  /// `nodes`: rows of NodeColumns. `objects`: how many of the scene's have a texture.
  RecordedTextures(std::size_t objects, WorkTable nodes)
      : objects_(objects), nodes_(std::move(nodes)), index_(nodes_.rows()) {
    for (std::size_t k = 0; k < nodes_.rows(); ++k) {
      index_.set(NodeColumns::corner(nodes_.row(k)), static_cast<std::uint32_t>(k));
    }
  }

  std::size_t objects() const { return objects_; }
  /// Of a terminal node; those that are not recorded took nothing.
  TextureWork work(const Cell& cell) const {
    const auto row = index_.find(cell.corner);
    return row ? NodeColumns::read(nodes_.row(*row)) : TextureWork();
  }

 private:
  std::size_t objects_;
  WorkTable nodes_;
  PointIndex index_;  ///< rows of nodes_, by their cells' upper left corners: no two are on one
};

}  // namespace pyrasim::hw
