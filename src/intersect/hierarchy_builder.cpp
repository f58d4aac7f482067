// SPDX-License-Identifier: Apache-2.0
#include "intersect/hierarchy_builder.h"

#include <array>
#include <cstddef>
#include <numeric>

namespace pyrasim {
namespace {

constexpr int bins = 16;
constexpr std::uint32_t max_leaf_size = 8;
constexpr int heuristic_depth = 60;  // below it nodes are halved, which ends within 32 more levels
/// Cost of one more inner node (two box tests), in surface tests.
constexpr double node_cost = 1.0;

struct Bin {
  BoundingBox box;
  std::uint32_t count = 0;
};

struct Split {
  double cost = std::numeric_limits<double>::infinity();
  int axis = 0;
  int bin = 0;  ///< the first bin of the right-hand side
};

template <Course course>
class Builder {
 public:
  explicit Builder(const std::vector<BoundingBox>& boxes) : boxes_(boxes), centers_(boxes.size()) {
    hierarchy_.references.resize(boxes.size());
    std::iota(hierarchy_.references.begin(), hierarchy_.references.end(), 0U);
    for (std::size_t k = 0; k < boxes.size(); ++k) centers_[k] = boxes[k].center();
  }

  Hierarchy build() {
    if (boxes_.empty()) return std::move(hierarchy_);
    hierarchy_.nodes.reserve(2 * boxes_.size());
    hierarchy_.nodes.emplace_back();
    subdivide(0, 0, static_cast<std::uint32_t>(boxes_.size()), 0);
    return std::move(hierarchy_);
  }

 private:
  void subdivide(std::uint32_t node, std::uint32_t first, std::uint32_t count, int depth) {
    BoundingBox box;
    BoundingBox center_box;
    for (std::uint32_t k = first; k < first + count; ++k) {
      box.include(boxes_[hierarchy_.references[k]]);
      center_box.include(centers_[hierarchy_.references[k]]);
    }
    hierarchy_.nodes[node] = {box, first, count};
    if (count == 1) return;
    const Split split = best_split(box, center_box, first, count);
    const bool halved = depth >= heuristic_depth || !(split.cost < std::numeric_limits<double>::infinity());
    if (count <= max_leaf_size && (halved || split.cost >= count)) return;
    const std::uint32_t left_count = halved ? count / 2 : partition(split, center_box, first, count);
    const auto children = static_cast<std::uint32_t>(hierarchy_.nodes.size());
    hierarchy_.nodes.resize(children + 2);
    hierarchy_.nodes[node].first = children;
    hierarchy_.nodes[node].count = 0;
    subdivide(children, first, left_count, depth + 1);
    subdivide(children + 1, first + left_count, count - left_count, depth + 1);
  }

  static int bin_of(double center, const BoundingBox& center_box, int axis) {
    const double extent = center_box.upper[axis] - center_box.lower[axis];
    const double position = (center - center_box.lower[axis]) / extent * bins;
    return std::min(static_cast<int>(position), bins - 1);
  }

  Split best_split(const BoundingBox& box, const BoundingBox& center_box, std::uint32_t first,
                   std::uint32_t count) const {
    std::array<std::array<Bin, bins>, 3> bin_along;
    const auto splits = [&](int axis) { return center_box.upper[axis] > center_box.lower[axis]; };
    for (std::uint32_t k = first; k < first + count; ++k) {
      const std::uint32_t reference = hierarchy_.references[k];
      for (int axis = 0; axis < 3; ++axis) {
        if (!splits(axis)) continue;
        const int its_bin = bin_of(centers_[reference][axis], center_box, axis);
        Bin& target = bin_along[static_cast<std::size_t>(axis)][static_cast<std::size_t>(its_bin)];
        target.box.include(boxes_[reference]);
        ++target.count;
      }
    }
    Split best;
    for (int axis = 0; axis < 3; ++axis) {
      if (splits(axis)) sweep(bin_along[static_cast<std::size_t>(axis)], axis, seen_area(box, course), best);
    }
    return best;
  }

  static void sweep(const std::array<Bin, bins>& bin, int axis, double area, Split& best) {
    std::array<double, bins> right_cost{};
    Bin right;
    double cost_of_right = -1;
    for (std::size_t k = bins - 1; k > 0; --k) {
      if (bin[k].count > 0) {
        right.box.include(bin[k].box);
        right.count += bin[k].count;
        cost_of_right = seen_area(right.box, course) * right.count;
      }
      right_cost[k] = cost_of_right;
    }
    Bin left;
    for (std::size_t k = 1; k < bins; ++k) {
      if (bin[k - 1].count == 0) continue;  // nothing on the left yet, or the same split as before
      if (right_cost[k] < 0) break;
      left.box.include(bin[k - 1].box);
      left.count += bin[k - 1].count;
      const double sides = seen_area(left.box, course) * left.count + right_cost[k];
      const double cost = node_cost + (area > 0 ? sides / area : 0);
      if (cost < best.cost) best = {cost, axis, static_cast<int>(k)};
    }
  }

  std::uint32_t partition(const Split& split, const BoundingBox& center_box, std::uint32_t first, std::uint32_t count) {
    const auto begin = hierarchy_.references.begin() + first;
    const auto middle = std::stable_partition(begin, begin + count, [&](std::uint32_t reference) {
      return bin_of(centers_[reference][split.axis], center_box, split.axis) < split.bin;
    });
    return static_cast<std::uint32_t>(middle - begin);
  }

  const std::vector<BoundingBox>& boxes_;
  std::vector<glm::dvec3> centers_;
  Hierarchy hierarchy_{course, {}, {}};
};

}  // namespace

Hierarchy build_hierarchy(const std::vector<BoundingBox>& boxes, Course course) {
  return course == Course::along_x ? Builder<Course::along_x>(boxes).build() : Builder<Course::any>(boxes).build();
}

std::vector<const BinaryNode*> wide_children(const Hierarchy& hierarchy, const BinaryNode& node) {
  const auto* const nodes = hierarchy.nodes.data();
  std::vector<const BinaryNode*> children{nodes + node.first, nodes + node.first + 1};
  const auto area = [&](const BinaryNode* child) { return seen_area(child->box, hierarchy.course); };
  while (children.size() < node_width) {
    const BinaryNode** largest = nullptr;
    for (const BinaryNode*& child : children) {
      if (child->count > 0) continue;
      if (largest == nullptr || area(child) > area(*largest)) largest = &child;
    }
    if (largest == nullptr) break;
    const std::uint32_t first = (*largest)->first;
    *largest = nodes + first;
    children.push_back(nodes + first + 1);
  }
  return children;
}

}  // namespace pyrasim
