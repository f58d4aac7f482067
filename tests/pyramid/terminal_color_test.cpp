// SPDX-License-Identifier: Apache-2.0
#include "pyramid/terminal_color.h"

#include <gtest/gtest.h>

#include "../test_scenes.h"
#include "pyramid/trace_tree.h"

namespace pyrasim {
namespace {

/// Background (1/8, 1/4, 1/2); object 0 is (1, 1/2, 0), object 1 is (0, 1/4, 3/4).
Palette palette() {
  Scene scene = empty_scene(1, 1, 1);
  scene.objects = {object(Sphere{{5, 0, 0}, 1}, {1, 0.5, 0}), object(Sphere{{9, 0, 0}, 1}, {0, 0.25, 0.75})};
  return {scene, 1};
}

glm::vec3 edge_color(const CornerSamples& corners, EdgePolicy edge) {
  TextureWork work;
  return single_node_result(palette().terminal_color(classify(corners), corners, edge, {}, work));
}

constexpr Sample nothing{};

TEST(TerminalColor, EmptyIsTheBackground) {
  for (const EdgePolicy edge : {EdgePolicy::mean, EdgePolicy::drop}) {
    EXPECT_EQ(edge_color({nothing, nothing, nothing, nothing}, edge), glm::vec3(0.125, 0.25, 0.5));
  }
}

TEST(TerminalColor, CoveredIsTheColorTimesTheMeanShading) {
  for (const EdgePolicy edge : {EdgePolicy::mean, EdgePolicy::drop}) {
    // (1/2 + 1/4 + 1 + 1/4) / 4 = 1/2
    EXPECT_EQ(edge_color({{{{0}, 0.5}, {{0}, 0.25}, {{0}, 1}, {{0}, 0.25}}}, edge), glm::vec3(0.5, 0.25, 0));
  }
}

TEST(TerminalColor, EdgeIsTheMeanOfTheFourSamples) {
  // One of object 0 at half brightness, two of object 1, one of the background:
  // red (1/2 + 0 + 0 + 1/8) / 4, green (1/4 + 1/4 + 1/4 + 1/4) / 4, blue (0 + 3/4 + 3/4 + 1/2) / 4
  EXPECT_EQ(edge_color({{{{0}, 0.5}, {{1}, 1}, {{1}, 1}, nothing}}, EdgePolicy::mean), glm::vec3(0.15625, 0.25, 0.5));
}

TEST(TerminalColor, DroppedEdgeIsTheBackground) {
  EXPECT_EQ(edge_color({{{{0}, 0.5}, {{1}, 1}, {{1}, 1}, nothing}}, EdgePolicy::drop), glm::vec3(0.125, 0.25, 0.5));
}

/// Sums of the four corners do not depend on which corner is which.
TEST(TerminalColor, EdgeDoesNotDependOnTheOrderOfCorners) {
  CornerSamples corners{{{{0}, 0.3}, {{1}, 0.7}, {{0}, 0.1}, nothing}};
  const glm::vec3 expected = edge_color(corners, EdgePolicy::mean);
  for (int k = 0; k < 4; ++k) {
    std::rotate(corners.begin(), corners.begin() + 1, corners.end());
    EXPECT_EQ(edge_color(corners, EdgePolicy::mean), expected);
  }
}

TEST(SampleColor, IsTheColorTimesTheShading) {
  TextureWork work;
  EXPECT_EQ(single_node_result(palette().sample_color({{1}, 0.5}, {}, work)), glm::vec3(0, 0.125, 0.375));
  EXPECT_EQ(single_node_result(palette().sample_color({{1}, 0.5}, {}, work, 2)), glm::vec3(0, 0.0625, 0.1875));
  EXPECT_EQ(single_node_result(palette().sample_color(nothing, {}, work)), glm::vec3(0.125, 0.25, 0.5));
}

}  // namespace
}  // namespace pyrasim
