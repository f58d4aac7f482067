// SPDX-License-Identifier: Apache-2.0
#include "intersect/hierarchy_builder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "../test_scenes.h"

namespace pyrasim {
namespace {

BoundingBox cube(const glm::dvec3& center, double radius) {
  BoundingBox box;
  box.include(center - glm::dvec3(radius));
  box.include(center + glm::dvec3(radius));
  return box;
}

bool contains(const BoundingBox& outer, const BoundingBox& inner) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!(outer.lower[axis] <= inner.lower[axis] && outer.upper[axis] >= inner.upper[axis])) return false;
  }
  return true;
}

/// Walks the whole tree: what each node claims, and that nothing is in it twice.
struct Walk {
  const Hierarchy& hierarchy;
  const std::vector<BoundingBox>& boxes;
  std::vector<int> seen = std::vector<int>(boxes.size());
  int depth = 0;
  std::size_t nodes = 0;

  void visit(std::uint32_t index, int level) {
    const BinaryNode& node = hierarchy.nodes.at(index);
    ++nodes;
    depth = std::max(depth, level);
    if (node.count == 0) {
      for (std::uint32_t k = 0; k < 2; ++k) {
        ASSERT_GT(node.first + k, index);
        EXPECT_TRUE(contains(node.box, hierarchy.nodes.at(node.first + k).box));
        visit(node.first + k, level + 1);
      }
      return;
    }
    for (std::uint32_t k = node.first; k < node.first + node.count; ++k) {
      const std::uint32_t reference = hierarchy.references.at(k);
      ++seen.at(reference);
      EXPECT_TRUE(contains(node.box, boxes[reference]));
    }
  }
};

/// Checks the hierarchy over `boxes` and returns its depth.
int check(const std::vector<BoundingBox>& boxes) {
  const Hierarchy hierarchy = build_hierarchy(boxes, Course::along_x);
  EXPECT_EQ(hierarchy.references.size(), boxes.size());
  Walk walk{hierarchy, boxes};
  walk.visit(0, 0);
  EXPECT_EQ(walk.nodes, hierarchy.nodes.size());
  for (std::size_t k = 0; k < boxes.size(); ++k) EXPECT_EQ(walk.seen[k], 1) << k;
  EXPECT_LE(walk.depth, max_hierarchy_depth);
  return walk.depth;
}

TEST(Hierarchy, OfNothingIsEmpty) {
  const Hierarchy hierarchy = build_hierarchy({}, Course::along_x);
  EXPECT_TRUE(hierarchy.nodes.empty());
  EXPECT_TRUE(hierarchy.references.empty());
}

TEST(Hierarchy, OfOneBoxIsALeaf) {
  const Hierarchy hierarchy = build_hierarchy({cube({1, 2, 3}, 1)}, Course::along_x);
  ASSERT_EQ(hierarchy.nodes.size(), 1U);
  EXPECT_EQ(hierarchy.nodes[0].count, 1U);
}

TEST(Hierarchy, RandomBoxes) {
  std::mt19937_64 random(7);
  for (const std::size_t count : {2U, 3U, 8U, 9U, 100U, 5000U}) {
    std::vector<BoundingBox> boxes;
    for (std::size_t k = 0; k < count; ++k) {
      boxes.push_back(cube(random_vector(random, glm::dvec3(-9), glm::dvec3(9)), (random() % 100) / 50.0));
    }
    EXPECT_LE(check(boxes), 40) << count;
  }
}

TEST(Hierarchy, FarApartBoxesAreSplit) {
  std::vector<BoundingBox> boxes;
  for (int k = 0; k < 4; ++k) boxes.push_back(cube({0, 0, 1000.0 * k}, 1));
  EXPECT_GE(check(boxes), 1);
}

TEST(Hierarchy, CoincidentBoxesAreHalved) {
  EXPECT_LE(check(std::vector<BoundingBox>(10'000, cube({1, 2, 3}, 1))), 14);
}

TEST(Hierarchy, FlatBoxesInALine) {
  std::vector<BoundingBox> boxes;
  for (int k = 0; k < 300; ++k) boxes.push_back(cube({1.0 * k, 0, 0}, 0));
  check(boxes);
}

/// Distances that shrink by a constant factor peel off a few boxes a level: the depth stays bounded all the same.
TEST(Hierarchy, GeometricSpacingKeepsTheDepthBound) {
  for (const double ratio : {0.5, 0.05, 1e-3}) {
    std::vector<BoundingBox> boxes;
    double x = 1;
    for (int k = 0; k < 1000 && x > 1e-290; ++k, x *= ratio) boxes.push_back(cube({x, 0, 0}, x / 8));
    for (int k = 0; k < 2000; ++k) boxes.push_back(cube({0, 0, 0}, 0));
    check(boxes);
  }
}

TEST(BoundingBox, FrontalAreaIsWhatARayAlongXSees) {
  EXPECT_EQ(BoundingBox().frontal_area(), 0);
  const BoundingBox box{{1, 2, 3}, {9, 4, 6}};
  EXPECT_EQ(box.frontal_area(), 2 * 3);
}

TEST(BoundingBox, HalfItsSurfaceIsThreeOfItsSides) {
  EXPECT_EQ(BoundingBox().half_surface(), 0);
  const BoundingBox box{{1, 2, 3}, {9, 4, 6}};
  EXPECT_EQ(box.half_surface(), 8 * 2 + 2 * 3 + 3 * 8);
}

}  // namespace
}  // namespace pyrasim
