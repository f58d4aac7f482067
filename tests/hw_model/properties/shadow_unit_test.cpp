// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "frames.h"

namespace pyrasim::hw {
namespace {

constexpr const char* samples_seen = "intersection_unit_0_to_shadow_unit_0";
constexpr const char* samples_lit = "shadow_unit_0_to_pyramid_classifier";

/// Every ray sees a wall, and three lamps in front of it: three shadow rays, each with one test of a plane.
Frame wall_under_three_lamps() {
  Frame frame{empty_scene(6, 4, 1), quick_machine()};
  frame.scene.objects = {object(Plane{{1, 0, 0}, 5})};
  frame.scene.lights = std::vector<Light>{AmbientLight{{1, 1, 1}}};
  for (const double y : {-1.0, 0.0, 1.0}) {
    frame.scene.lights->emplace_back(PointLight{{0, y, 0}, {1, 1, 1}, Falloff::none, true});
  }
  frame.spec.shadow_unit = {.latency = 1, .ray = 2};
  frame.spec.intersection_cost.surface_test[index_of_kind<PlaneSurface>] = 4;
  return frame;
}
constexpr Cycle work_on_wall = 1 + 3 * (2 + 4);

TEST(ShadowUnit, ASampleIsThereAfterWorkAndLatencyAndNotBefore) {
  std::vector<Frame> frames;
  for (const Cycle latency : {1, 2, 9}) {
    frames.push_back(wall_under_three_lamps());
    frames.back().spec.shadow_unit.latency = latency;
  }
  for (const Dated& frame : dates_of(frames)) {
    SCOPED_TRACE(frame.name);
    EXPECT_EQ(shortest_stay(frame.fifo(samples_lit)), work_on_wall + frame.spec.shadow_unit.latency - 1);
  }
}

TEST(ShadowUnit, SamplesOfTheSameWorkStartThatWorkApart) {
  for (const Dated& frame : dates_of({wall_under_three_lamps()})) {
    SCOPED_TRACE(frame.name);
    expect_gaps(frame.fifo(samples_seen).reads, work_on_wall);
    EXPECT_EQ(frame.fifo(samples_lit).writes, frame.fifo(samples_seen).reads);
  }
}

/// What sees nothing has no shadow rays, and passes in a cycle.
TEST(ShadowUnit, ASampleOfTheBackgroundTakesOneCycle) {
  Frame frame = wall_under_three_lamps();
  frame.scene.objects = {object(Plane{{1, 0, 0}, -5})};
  for (const Dated& dated : dates_of({frame})) {
    SCOPED_TRACE(dated.name);
    EXPECT_EQ(shortest_stay(dated.fifo(samples_lit)), 1U);
    EXPECT_FALSE(dated.timeline.fifos.contains("intersection_unit_0_to_pyramid_classifier"));
  }
}

TEST(ShadowUnit, WaitsForRoomAndStartsTheCycleAfterTheRead) {
  std::vector<Frame> frames;
  for (const std::size_t depth : {1, 2, 5}) {
    frames.push_back(wall_under_three_lamps());
    frames.back().scene.objects = {object(Plane{{1, 0, 0}, -5})};
    frames.back().spec.intersection_cost.surface_test = {};
    frames.back().spec.pyramid_classifier.interval = 7;
    frames.back().spec.fifos.shadow_unit_to_pyramid_classifier = depth;
  }
  for (const Dated& frame : dates_of(frames)) {
    SCOPED_TRACE(frame.name);
    expect_writes_as_soon_as_freed(frame.fifo(samples_lit), frame.spec.fifos.shadow_unit_to_pyramid_classifier);
  }
}

/// It is there for nothing but shadows.
TEST(ShadowUnit, StandsOnlyWhereSomethingCastsOne) {
  std::vector<Frame> frames(4, wall_under_three_lamps());
  frames[0].scene.lights.reset();
  for (std::size_t k = 1; k < 4; ++k) std::get<PointLight>(frames[1].scene.lights->at(k)).shadow = false;
  frames[2].scene.objects[0].casts_shadow = false;
  frames[3].scene.objects.clear();
  for (const Dated& frame : dates_of(frames)) {
    SCOPED_TRACE(frame.name);
    EXPECT_TRUE(frame.timeline.fifos.contains("intersection_unit_0_to_pyramid_classifier"));
    EXPECT_FALSE(frame.timeline.fifos.contains(samples_seen));
  }
}

}  // namespace
}  // namespace pyrasim::hw
