// SPDX-License-Identifier: Apache-2.0
#include "intersect/box_hierarchy.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#if defined(__AVX__)
#include <immintrin.h>
#endif

namespace pyrasim {
namespace {

constexpr double granted = 1 + 16 * 0x1p-53;
/// As far as rays go that have no limit: less far than those get that run beside a box along its planes.
constexpr double furthest = 0x1p1000;

}  // namespace

BoxHierarchy::BoxHierarchy(const std::vector<BoundingBox>& boxes) {
  Hierarchy hierarchy = build_hierarchy(boxes, Course::any);
  if (hierarchy.nodes.empty()) return;
  leaves_.clear();
  root_ = add(hierarchy, hierarchy.nodes.front());
  items_ = std::move(hierarchy.references);
}

/// The largest child first: of rays that ask whether anything is there, most end in it.
std::int32_t BoxHierarchy::add(const Hierarchy& hierarchy, const BinaryNode& node) {
  if (node.count > 0) {
    leaves_.push_back({node.first, node.count});
    return ~static_cast<std::int32_t>(leaves_.size() - 1);
  }
  const auto index = nodes_.size();
  nodes_.emplace_back();
  std::vector<const BinaryNode*> children = wide_children(hierarchy, node);
  std::stable_sort(children.begin(), children.end(), [](const BinaryNode* a, const BinaryNode* b) {
    return a->box.half_surface() > b->box.half_surface();
  });
  Node wide;
  wide.children = static_cast<std::uint32_t>(children.size());
  for (std::size_t k = 0; k < children.size(); ++k) {
    for (int axis = 0; axis < 3; ++axis) {
      wide.lower[static_cast<std::size_t>(axis)][k] = children[k]->box.lower[axis];
      wide.upper[static_cast<std::size_t>(axis)][k] = children[k]->box.upper[axis];
    }
    wide.child[k] = add(hierarchy, *children[k]);
  }
  nodes_[index] = wide;
  return static_cast<std::int32_t>(index);
}

/// A ray along an axis' planes is between them for ever or never: far enough in either direction, for the numbers there
/// are. On a plane itself it may be taken for outside: no surface is that close to it, for boxes are grown.
BoxHierarchy::Query::Query(const glm::dvec3& origin, const glm::dvec3& direction, double margin)
    : above(origin + margin), below(origin - margin) {
  constexpr double most = std::numeric_limits<double>::max();
  for (int axis = 0; axis < 3; ++axis) {
    inverse[axis] = direction[axis] == 0 ? most : std::clamp(1 / direction[axis], -most, most);
  }
}

double BoxHierarchy::entered(const BoundingBox& box, const Query& query) {
  double enter = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double a = (box.lower[axis] - query.above[axis]) * query.inverse[axis];
    const double b = (box.upper[axis] - query.below[axis]) * query.inverse[axis];
    enter = std::max(enter, std::min(a, b));
  }
  return enter;
}

/// The slab test (Kay, Kajiya 1986): per axis the t at which the ray passes two planes, each by a difference, a
/// reciprocal and a product; the last comparison grants their roundings (Ize, Robust BVH Ray Traversal, JCGT 2013).
#if defined(__AVX__)
unsigned BoxHierarchy::met(const Node& node, const Query& query, double limit) {
  __m256d enter = _mm256_setzero_pd();
  __m256d leave = _mm256_set1_pd(std::min(limit, furthest));
  for (int axis = 0; axis < 3; ++axis) {
    const auto k = static_cast<std::size_t>(axis);
    const __m256d inverse = _mm256_set1_pd(query.inverse[axis]);
    const auto passed = [&](const Node::Bound& bound, double from) {
      return _mm256_mul_pd(_mm256_sub_pd(_mm256_load_pd(bound.data()), _mm256_set1_pd(from)), inverse);
    };
    const __m256d a = passed(node.lower[k], query.above[axis]);
    const __m256d b = passed(node.upper[k], query.below[axis]);
    enter = _mm256_max_pd(enter, _mm256_min_pd(a, b));
    leave = _mm256_min_pd(leave, _mm256_max_pd(a, b));
  }
  const __m256d met = _mm256_cmp_pd(enter, _mm256_mul_pd(leave, _mm256_set1_pd(granted)), _CMP_LE_OQ);
  return static_cast<unsigned>(_mm256_movemask_pd(met)) & ((1U << node.children) - 1);
}
#else
unsigned BoxHierarchy::met(const Node& node, const Query& query, double limit) {
  unsigned met = 0;
  for (std::size_t k = 0; k < node_width; ++k) {
    double enter = 0;
    double leave = std::min(limit, furthest);
    for (int axis = 0; axis < 3; ++axis) {
      const auto which = static_cast<std::size_t>(axis);
      const double a = (node.lower[which][k] - query.above[axis]) * query.inverse[axis];
      const double b = (node.upper[which][k] - query.below[axis]) * query.inverse[axis];
      enter = std::max(enter, std::min(a, b));
      leave = std::min(leave, std::max(a, b));
    }
    if (enter <= leave * granted) met |= 1U << k;
  }
  return met & ((1U << node.children) - 1);
}
#endif

}  // namespace pyrasim
