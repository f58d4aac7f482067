// SPDX-License-Identifier: Apache-2.0
#include "study/decision_flips.h"

#include <gtest/gtest.h>

#include "../test_scenes.h"
#include "intersect/scene_intersector.h"
#include "numeric/number_types.h"
#include "render/pyramid_renderer.h"

namespace pyrasim {
namespace {

/// A half-plane of objects: everything above the row `row` of a screen of 4 x 4 pixels belongs to an object.
class HalfPlane final : public Intersector {
 public:
  explicit HalfPlane(double slope) : slope_(slope) {}
  Sample intersect(const glm::dvec3& view_vector, Work&) const override {
    return view_vector.y > slope_ ? Sample{{0}} : Sample{};
  }
  SceneContents contents() const override { return {}; }

 private:
  double slope_;
};

/// Pixels one unit high: the rows of corners lie at y = 2, 1, 0, -1, -2.
Scene four_by_four() {
  Scene scene = empty_scene(4, 4, 1);
  scene.camera.screen = {4, 4, 1, 1, 1};
  return scene;
}

TEST(DecisionFlips, EqualDatapathsHaveNone) {
  const Scene scene = four_by_four();
  const HalfPlane edge(0.3);
  // 16 pixels; 4 of them split, into 2 edges above each other's sides and so on: each level doubles the edges.
  const DecisionFlips flips = decision_flips(scene, {edge, {}}, {edge, {}}, 2, 1);
  EXPECT_EQ(flips, (DecisionFlips{.decisions = 16 + 4 * 4 + 8 * 4}));
}

TEST(DecisionFlips, ByHandWithoutSubdivision) {
  const Scene scene = four_by_four();
  const HalfPlane low(0.3);
  const HalfPlane high(1.3);
  // Row 0 (y from 2 to 1): covered against edge. Row 1 (1 to 0): edge against empty. The others are empty for both.
  EXPECT_EQ(decision_flips(scene, {low, {}}, {high, {}}, 0, 1), (DecisionFlips{.decisions = 16, .flipped = 8}));
}

TEST(DecisionFlips, SubdivisionsOfOneSideCountToTheDeepestLevel) {
  const Scene scene = four_by_four();
  const HalfPlane low(0.3);
  const HalfPlane high(1.3);
  // Either edge splits 4 pixels at level 0, and 8 subpixels at level 1: none of them in common.
  const DecisionFlips flips = decision_flips(scene, {low, {}}, {high, {}}, 2, 1);
  EXPECT_EQ(flips, (DecisionFlips{.decisions = 16, .flipped = 8, .extra_subdivisions = 12, .lost_subdivisions = 12}));
}

TEST(DecisionFlips, AnotherObjectIsAnotherDecision) {
  class Everywhere final : public Intersector {
   public:
    explicit Everywhere(std::uint32_t object) : object_(object) {}
    Sample intersect(const glm::dvec3&, Work&) const override { return {{object_}}; }
    SceneContents contents() const override { return {}; }

   private:
    std::uint32_t object_;
  };
  const Scene scene = four_by_four();
  const Everywhere first(0);
  const Everywhere second(1);
  EXPECT_EQ(decision_flips(scene, {first, {}}, {second, {}}, 3, 1), (DecisionFlips{.decisions = 16, .flipped = 16}));
}

/// The view vectors' own rounding counts: with 8 bits of significand y = 0.30078125 becomes 0.30078125, 0.3007 not.
TEST(DecisionFlips, ViewVectorsAreRoundedToTheirFormat) {
  Scene scene = four_by_four();
  scene.camera.screen.dy = 0.3007;  // corners at 0.6014, 0.3007, 0, ...
  const HalfPlane edge(0.30075);
  const DecisionFlips flips = decision_flips(scene, {edge, {}}, {edge, bf16}, 0, 1);
  EXPECT_EQ(flips, (DecisionFlips{.decisions = 16, .flipped = 8}));
}

/// A frame's balance: what the studied datapath subdivides is what the reference does, and the extra, less the lost.
TEST(DecisionFlips, ExtraLessLostIsTheDifferenceOfSubdivisions) {
  const Scene scene = random_scene(7, {30, 30, 1}, 50, 37);
  constexpr int max_level = 3;
  const auto exact = make_intersector(scene);
  const PyramidOptions options{.max_level = max_level};
  const std::uint64_t reference = render_pyramids(scene, *exact, options).statistics.subdivisions;
  int differing = 0;
  for (const char* name : {"float", "fp24", "bf16", "fix64.16", "fix32.20"}) {
    const NumberFormat format = parse_number_format(name);
    const auto intersector = make_intersector(scene, format);
    const FrameStatistics studied =
        render_pyramids(scene, *intersector, {.max_level = max_level, .view_vectors = format}).statistics;
    const DecisionFlips flips = decision_flips(scene, {*exact, {}}, {*intersector, format}, max_level, 1);
    EXPECT_EQ(reference + flips.extra_subdivisions - flips.lost_subdivisions, studied.subdivisions) << name;
    EXPECT_GE(flips.flipped, flips.lost_subdivisions > 0 ? 1U : 0U) << name;
    EXPECT_EQ(flips, decision_flips(scene, {*exact, {}}, {*intersector, format}, max_level, 3)) << name;
    differing += flips.extra_subdivisions + flips.lost_subdivisions > 0 ? 1 : 0;
  }
  EXPECT_GE(differing, 3);
}

}  // namespace
}  // namespace pyrasim
