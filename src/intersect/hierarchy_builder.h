// SPDX-License-Identifier: Apache-2.0
// Builds a binary bounding volume hierarchy by the surface area heuristic over binned centroids (Wald 2007), with the
// area that a ray sees of a box.
#pragma once

#include <cstddef>
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

/// Which way the rays run that it is for: along x, as view rays do in slope space, or any way.
enum class Course { along_x, any };

/// What a ray sees of a box, on average.
inline double seen_area(const BoundingBox& box, Course course) {
  return course == Course::along_x ? box.frontal_area() : box.half_surface();
}

struct Hierarchy {
  Course course;
  std::vector<BinaryNode> nodes;          ///< the root is nodes[0]; none for no boxes
  std::vector<std::uint32_t> references;  ///< indices of the boxes given, ordered by leaf
};

/// No path from the root to a leaf is longer.
inline constexpr int max_hierarchy_depth = 96;

/// `boxes`: one for each bounded surface.
Hierarchy build_hierarchy(const std::vector<BoundingBox>& boxes, Course course);

/// Children of a wide node at most.
inline constexpr std::size_t node_width = 4;

/// The children of a wide node: those of the binary inner node `node`, the largest inner one replaced by its own while
/// there is room.
std::vector<const BinaryNode*> wide_children(const Hierarchy& hierarchy, const BinaryNode& node);

}  // namespace pyrasim
