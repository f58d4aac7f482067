// SPDX-License-Identifier: Apache-2.0
// Builds a binary bounding volume hierarchy for rays that run along x, as view rays do in slope space: by the
// surface area heuristic over binned centroids (Wald 2007), with the area that such a ray sees of a box.
#pragma once

#include <cstdint>
#include <vector>

#include "surface/bounding_box.h"

namespace pyrasim {

/// A node of the hierarchy: a leaf holds the references `first` to `first + count - 1` of Hierarchy::references; an
/// inner node (count = 0) has the children `first` and `first + 1` of Hierarchy::nodes.
struct BinaryNode {
  BoundingBox box;
  std::uint32_t first = 0;
  std::uint32_t count = 0;
};

struct Hierarchy {
  std::vector<BinaryNode> nodes;          ///< the root is nodes[0]; none for no boxes
  std::vector<std::uint32_t> references;  ///< indices of the boxes given, ordered by leaf
};

/// No path from the root to a leaf is longer.
inline constexpr int max_hierarchy_depth = 96;

/// `boxes`: one for each bounded surface.
Hierarchy build_hierarchy(const std::vector<BoundingBox>& boxes);

}  // namespace pyrasim
