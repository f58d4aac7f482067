// SPDX-License-Identifier: Apache-2.0
// The hierarchy's splits are the cheapest that there are: small sets of boxes, where all splits can be tried.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <random>

#include "../test_scenes.h"
#include "intersect/hierarchy_builder.h"
#include "intersect/scene_intersector.h"
#include "surface/slope_bounds.h"

namespace pyrasim {
namespace {

using Boxes = std::vector<BoundingBox>;
using Set = std::vector<std::uint32_t>;  ///< indices of boxes

/// Boxes, and which way the rays run.
struct Given {
  Boxes boxes;
  Course course;
};

/// What a ray sees of a set: its sides across y and z where rays run along x, else all that there are of its sides.
double area(const Given& given, const Set& set) {
  const double infinity = std::numeric_limits<double>::infinity();
  std::array<double, 3> side{};
  for (int axis = 0; axis < 3; ++axis) {
    double lower = infinity;
    double upper = -infinity;
    for (const std::uint32_t k : set) {
      lower = std::min(lower, given.boxes[k].lower[axis]);
      upper = std::max(upper, given.boxes[k].upper[axis]);
    }
    side[static_cast<std::size_t>(axis)] = upper - lower;
  }
  const auto [x, y, z] = side;
  return given.course == Course::along_x ? y * z : x * y + x * z + y * z;
}

/// The surface area heuristic: a box is met by the share of its parent's rays that its area is of the parent's. In
/// surface tests of a ray that meets both: one for the boxes, and those of a side for the rays that meet it.
double cost(const Given& given, const Set& left, const Set& right) {
  Set both = left;
  both.insert(both.end(), right.begin(), right.end());
  const double sides =
      area(given, left) * static_cast<double>(left.size()) + area(given, right) * static_cast<double>(right.size());
  return 1 + sides / area(given, both);
}

/// The least cost among the splits by a plane across any axis, between any two centres.
double least_cost(const Given& given, Set set) {
  double least = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    std::sort(set.begin(), set.end(),
              [&](auto p, auto q) { return given.boxes[p].center()[axis] < given.boxes[q].center()[axis]; });
    for (auto middle = set.begin() + 1; middle != set.end(); ++middle) {
      least = std::min(least, cost(given, Set(set.begin(), middle), Set(middle, set.end())));
    }
  }
  return least;
}

/// Whether no two centres share one of the 16 bins of any axis: then all splits between two of them can be had.
bool all_apart(const Boxes& boxes, const Set& set) {
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> centers;
    for (const std::uint32_t k : set) centers.push_back(boxes[k].center()[axis]);
    std::sort(centers.begin(), centers.end());
    for (std::size_t k = 1; k < centers.size(); ++k) {
      if (centers[k] - centers[k - 1] <= (centers.back() - centers.front()) / 16 * (1 + 1e-9)) return false;
    }
  }
  return true;
}

struct Counts {
  int splits = 0;
  int small_splits = 0;  ///< of sets that could be a leaf
  int leaves = 0;        ///< of several boxes
};

/// Checks every choice of the hierarchy below `index`, where all could be had. Returns the node's boxes.
Set check(const Given& given, const Hierarchy& hierarchy, std::uint32_t index, Counts& counts) {
  const BinaryNode& node = hierarchy.nodes.at(index);
  if (node.count > 0) {
    const auto first = hierarchy.references.begin() + node.first;
    const Set set(first, first + node.count);
    EXPECT_LE(set.size(), 8U);
    if (set.size() > 1 && all_apart(given.boxes, set)) {
      ++counts.leaves;
      EXPECT_GE(least_cost(given, set), static_cast<double>(set.size()) - 1e-9) << "a split would cost less";
    }
    return set;
  }
  const Set left = check(given, hierarchy, node.first, counts);
  const Set right = check(given, hierarchy, node.first + 1, counts);
  Set set = left;
  set.insert(set.end(), right.begin(), right.end());
  if (!all_apart(given.boxes, set)) return set;
  ++counts.splits;
  counts.small_splits += set.size() <= 8 ? 1 : 0;
  EXPECT_NEAR(cost(given, left, right), least_cost(given, set), 1e-9) << set.size() << " boxes";
  if (set.size() <= 8) {
    EXPECT_LT(least_cost(given, set), static_cast<double>(set.size())) << "a leaf costs less";
  }
  return set;
}

/// Centres on whole numbers from 0 to `count` - 1, each once along every axis.
Boxes boxes_apart(std::size_t count, double largest_side, std::mt19937_64& random) {
  Boxes boxes(count);
  std::array<std::vector<double>, 3> places;
  for (auto& along : places) {
    along.resize(count);
    for (std::size_t k = 0; k < count; ++k) along[k] = static_cast<double>(k);
    std::shuffle(along.begin(), along.end(), random);
  }
  for (std::size_t k = 0; k < count; ++k) {
    const glm::dvec3 center(places[0][k], places[1][k], places[2][k]);
    const glm::dvec3 half = random_vector(random, glm::dvec3(0.01), glm::dvec3(largest_side / 2));
    boxes[k] = {center - half, center + half};
  }
  return boxes;
}

class SplitChoiceFor : public testing::TestWithParam<Course> {};

TEST_P(SplitChoiceFor, IsTheCheapestOfAll) {
  std::mt19937_64 random(3);
  Counts counts;
  for (int round = 0; round < 40; ++round) {
    for (std::size_t count = 2; count <= 16; ++count) {
      for (const double largest_side : {0.5, 4.0, 20.0}) {
        SCOPED_TRACE(testing::Message() << "round " << round << ", sides up to " << largest_side);
        const Given given{boxes_apart(count, largest_side, random), GetParam()};
        const Hierarchy hierarchy = build_hierarchy(given.boxes, given.course);
        check(given, hierarchy, 0, counts);
      }
    }
  }
  EXPECT_GT(counts.splits, 1000);
  EXPECT_GT(counts.small_splits, 300);
  EXPECT_GT(counts.leaves, 100);
}

INSTANTIATE_TEST_SUITE_P(Rays, SplitChoiceFor, testing::Values(Course::along_x, Course::any),
                         [](const auto& course) { return course.param == Course::along_x ? "along_x" : "any"; });

/// A tree of spheres, by their places in the scene: a leaf's in brackets, a node's children in braces, all in order.
std::string written(std::vector<std::string> parts, const char* open, const char* close) {
  std::sort(parts.begin(), parts.end());
  std::string text = open;
  for (const std::string& part : parts) text += part + " ";
  return text + close;
}

std::string tree_of(const PreparedScene<double>& scene, std::int32_t reference) {
  std::vector<std::string> parts;
  if (reference < 0) {
    const SurfaceRun& run = *first_run(scene.runs, reference);
    for (std::uint32_t k = run.first; k < run.first + run.count; ++k) {
      parts.push_back(std::to_string(surfaces_of<SphereSurface>(scene).at(k).identity.order));
    }
    return written(parts, "[", "]");
  }
  const auto& node = scene.nodes.at(static_cast<std::size_t>(reference));
  for (std::size_t k = 0; k < node.children; ++k) parts.push_back(tree_of(scene, node.child[k]));
  return written(parts, "{", "}");
}

/// The same from the binary hierarchy: of a node's children the one that is largest on the screen gives way to its own
/// two, until there are four or none can.
std::string wide_tree_of(const Hierarchy& hierarchy, std::uint32_t index) {
  const BinaryNode& node = hierarchy.nodes.at(index);
  std::vector<std::string> parts;
  if (node.count > 0) {
    for (std::uint32_t k = 0; k < node.count; ++k) {
      parts.push_back(std::to_string(hierarchy.references.at(node.first + k)));
    }
    return written(parts, "[", "]");
  }
  Set children{node.first, node.first + 1};
  const auto size = [&](std::uint32_t child) {
    const BoundingBox& box = hierarchy.nodes.at(child).box;
    const bool inner = hierarchy.nodes.at(child).count == 0;
    return inner ? (box.upper.y - box.lower.y) * (box.upper.z - box.lower.z) : -1;
  };
  while (children.size() < 4) {
    const auto largest =
        std::max_element(children.begin(), children.end(), [&](auto p, auto q) { return size(p) < size(q); });
    if (size(*largest) < 0) break;
    const std::uint32_t first = hierarchy.nodes.at(*largest).first;
    children.erase(largest);
    children.push_back(first);
    children.push_back(first + 1);
  }
  for (const std::uint32_t child : children) parts.push_back(wide_tree_of(hierarchy, child));
  return written(parts, "{", "}");
}

TEST(SplitChoice, OpensTheLargestChildOfAWideNode) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Scene scene = random_scene(seed, {60, 0, 0}, 32, 32);
    Boxes visible;
    for (const Object& entry : scene.objects) {
      const auto& sphere = std::get<Sphere>(entry.surface);
      visible.push_back(on_screen(slope_bounds_of_sphere(sphere.center, sphere.radius, 0), scene.camera.screen));
    }
    const SceneIntersector<double> intersector(scene);
    EXPECT_EQ(tree_of(intersector.scene(), intersector.scene().root),
              wide_tree_of(build_hierarchy(visible, Course::along_x), 0))
        << seed;
  }
}

}  // namespace
}  // namespace pyrasim
