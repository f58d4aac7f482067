// SPDX-License-Identifier: Apache-2.0
#include "pyramid/trace_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "../test_scenes.h"

namespace pyrasim {
namespace {

constexpr std::int64_t one = std::int64_t{1} << fixed_color_bits;

FixedColor color(double red, double green, double blue) {
  return {std::llrint(red * one), std::llrint(green * one), std::llrint(blue * one)};
}

struct Node {
  std::uint32_t level;
  FixedColor color;
};

glm::vec3 sum(const std::vector<Node>& nodes, int max_level) {
  TraceTree tree;
  for (const Node& node : nodes) {
    tree.add_terminal_node(static_cast<std::uint32_t>(max_level) - node.level, node.color);
  }
  EXPECT_TRUE(tree.complete(max_level));
  return tree.result(max_level);
}

/// A pixel split once, its subpixel 1 split again, and of that the subpixel 2 once more:
///   level 1: red, green, blue            each weighs 1/4
///   level 2: white, black, white         each weighs 1/16
///   level 3: white, white, white, black  each weighs 1/64
/// red   = 1/4 + 2/16 + 3/64 = 27/64, and so are green and blue.
TEST(TraceTree, WorkedOutOnPaper) {
  const FixedColor white = color(1, 1, 1);
  const FixedColor black = color(0, 0, 0);
  const std::vector<Node> nodes{{1, color(1, 0, 0)}, {1, color(0, 1, 0)}, {1, color(0, 0, 1)}, {2, white}, {2, black},
                                {2, white},          {3, white},          {3, white},          {3, white}, {3, black}};
  for (const int max_level : {3, 4, 10, max_level_limit}) {
    EXPECT_EQ(sum(nodes, max_level), glm::vec3(27.0F / 64)) << max_level;
  }
}

TEST(TraceTree, OrderOfNodesDoesNotMatter) {
  std::mt19937_64 random(11);
  std::vector<Node> nodes;
  for (std::uint32_t level = 1; level <= 9; ++level) {
    for (int k = 0; k < (level == 9 ? 4 : 3); ++k) {
      const glm::dvec3 c = random_vector(random, glm::dvec3(0), glm::dvec3(1));
      nodes.push_back({level, color(c.x, c.y, c.z)});
    }
  }
  const glm::vec3 expected = sum(nodes, 9);
  for (int k = 0; k < 200; ++k) {
    std::shuffle(nodes.begin(), nodes.end(), random);
    ASSERT_EQ(sum(nodes, 9), expected);
  }
}

TEST(TraceTree, WeightsAddUpToOneExactlyWhenComplete) {
  TraceTree tree;
  for (std::uint32_t log2_side = 5; log2_side-- > 0;) {
    for (int k = 0; k < 3; ++k) {
      EXPECT_FALSE(tree.complete(5));
      EXPECT_FALSE(tree.completed_by(log2_side, 5));
      tree.add_terminal_node(log2_side, color(1, 1, 1));
    }
  }
  EXPECT_FALSE(tree.complete(5));
  EXPECT_TRUE(tree.completed_by(0, 5));
  EXPECT_FALSE(tree.completed_by(1, 5));
  tree.add_terminal_node(0, color(1, 1, 1));
  EXPECT_TRUE(tree.complete(5));
  EXPECT_EQ(tree.result(5), glm::vec3(1));
}

/// The brightest colour in the deepest tree: a chain that takes three nodes a level, four at the last.
TEST(TraceTree, DeepestTreeOfTheBrightestColorDoesNotOverflow) {
  std::vector<Node> nodes;
  for (std::uint32_t level = 1; level <= max_level_limit; ++level) {
    for (int k = 0; k < (level == max_level_limit ? 4 : 3); ++k) nodes.push_back({level, color(max_color, 0, 1)});
  }
  EXPECT_EQ(sum(nodes, max_level_limit), glm::vec3(max_color, 0, 1));
}

TEST(TraceTree, SingleNodeEqualsATreeOfOneNode) {
  std::mt19937_64 random(3);
  for (int k = 0; k < 100; ++k) {
    const glm::dvec3 c = random_vector(random, glm::dvec3(0), glm::dvec3(2));
    const FixedColor fixed = color(c.x, c.y, c.z);
    EXPECT_EQ(sum({{0, fixed}}, 0), single_node_result(fixed));
    EXPECT_EQ(sum({{0, fixed}}, 7), single_node_result(fixed));
  }
}

/// Four equal quarters are the whole, bit for bit.
TEST(TraceTree, SplittingAConstantChangesNothing) {
  const FixedColor c = color(0.1, 0.7, 1.0 / 3);
  EXPECT_EQ(sum({{1, c}, {1, c}, {1, c}, {1, c}}, 1), single_node_result(c));
}

}  // namespace
}  // namespace pyrasim
