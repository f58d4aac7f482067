// SPDX-License-Identifier: Apache-2.0
#include "hw_model/plan/tester_parts.h"

#include <fmt/format.h>

#include "text/counted.h"

namespace pyrasim::hw {
namespace {

Need need_of_walker(std::size_t inner_nodes) {
  if (inner_nodes == 0) return {false, "the hierarchy is one leaf"};
  return {true, "the hierarchy has " + counted(inner_nodes, "inner node")};
}

Need need_of_tester(std::size_t surfaces) {
  if (surfaces == 0) return {false, "the scene has no such surface"};
  return {true, "the scene has " + counted(surfaces, "such surface")};
}

}  // namespace

std::vector<StagePart> tester_parts(const std::array<std::size_t, surface_kinds>& surfaces, std::size_t inner_nodes,
                                    const Tests& tests, const IntersectionCost& cost) {
  std::vector<StagePart> parts{{"hierarchy_walker", need_of_walker(inner_nodes), cost.box_test * tests.box_tests}};
  for (std::size_t kind = 0; kind < surface_kinds; ++kind) {
    parts.push_back({fmt::format("{}_tester", surface_traits[kind].name), need_of_tester(surfaces[kind]),
                     cost.surface_test[kind] * tests.surface_tests[kind]});
  }
  return parts;
}

}  // namespace pyrasim::hw
