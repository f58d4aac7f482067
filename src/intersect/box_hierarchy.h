// SPDX-License-Identifier: Apache-2.0
// A hierarchy of ordinary boxes, for rays that start anywhere and run anywhere: those of slope space serve rays from
// the observer only.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "intersect/hierarchy_builder.h"
#include "surface/bounding_box.h"

namespace pyrasim {

class BoxHierarchy {
 public:
  BoxHierarchy() = default;
  /// Boxes, or each query, are already grown by all that the arithmetic of what they hold may err by: they are compared
  /// in double, and the roundings of that alone are granted.
  explicit BoxHierarchy(const std::vector<BoundingBox>& boxes);

  /// A node of two to four children, their boxes side by side.
  struct alignas(64) Node {
    using Bound = std::array<double, node_width>;
    std::array<Bound, 3> lower{};  ///< by axis
    std::array<Bound, 3> upper{};
    std::array<std::int32_t, node_width> child{};  ///< index into nodes, or ~index into leaves
    std::uint32_t children = 0;
  };
  /// Items `first` to `first + count - 1`.
  struct Leaf {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
  };

  /// What boxes ask of a ray, worked out once.
  struct Query {
    glm::dvec3 above;    ///< the origin, and a margin on
    glm::dvec3 below;    ///< and the margin off
    glm::dvec3 inverse;  ///< 1 / direction; where the ray runs along an axis' planes, the largest number

    Query(const glm::dvec3& origin, const glm::dvec3& direction, double margin);
  };

  /// Bit k: the ray may meet what the box of child k holds at a t of at most `limit`.
  static unsigned met(const Node& node, const Query& query, double limit);

  /// The t at which the ray enters a box as such a comparison has it: no box that holds it is entered later.
  static double entered(const BoundingBox& box, const Query& query);

  const std::vector<Node>& nodes() const { return nodes_; }
  std::int32_t root() const { return root_; }  ///< as Node::child
  const Leaf& leaf(std::int32_t reference) const {
    return leaves_[static_cast<std::size_t>(~static_cast<std::int64_t>(reference))];
  }
  /// The boxes' numbers, in the order of leaves.
  const std::vector<std::uint32_t>& items() const { return items_; }

 private:
  /// Returns the reference of what it adds, as Node::child.
  std::int32_t add(const Hierarchy& hierarchy, const BinaryNode& node);

  std::vector<Node> nodes_;
  std::vector<Leaf> leaves_{Leaf{}};
  std::vector<std::uint32_t> items_;
  std::int32_t root_ = ~0;
};

}  // namespace pyrasim
