// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "intersect/hierarchy_builder.h"
#include "intersect/work.h"

namespace pyrasim {

/// One walk over the hierarchy `nodes` from `root` (as Node::child), whatever is sought and whatever leaves hold.
/// query.met(node): bit k, box k of the node may hold it; query.behind(node, k): not any more; leaf(reference) looks
/// there. The first child that may comes first; the others wait.
///
/// Inlined by force: kept in registers, the state of a walk costs a third less time than in memory.
template <class Node, class Query, class Leaf>
[[gnu::always_inline]] inline void traverse(const Node* nodes, std::int32_t root, const Query& query, const Leaf& leaf,
                                            Tests& work) {
  struct Pending {
    const Node* node;
    unsigned met;  ///< the children that wait
  };
  std::array<Pending, max_hierarchy_depth> stack;
  Pending* top = stack.data();
  Pending here{nullptr, 0};
  std::int32_t current = root;
  for (;;) {
    if (current >= 0) {
      if (here.met != 0) *top++ = here;
      here.node = &nodes[static_cast<std::size_t>(current)];
      here.met = query.met(*here.node);
      work.box_tests += here.node->children;
    } else {
      leaf(current);
    }
    std::size_t child = 0;
    const auto lowest_met = [&] { return child = static_cast<std::size_t>(std::countr_zero(here.met)); };
    while (here.met == 0 || query.behind(*here.node, lowest_met())) {
      if (top == stack.data()) return;
      here = *--top;
    }
    here.met &= here.met - 1;
    current = here.node->child[child];
  }
}

}  // namespace pyrasim
