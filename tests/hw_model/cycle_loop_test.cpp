// SPDX-License-Identifier: Apache-2.0
// The cycle loop by itself, on frames worked out on paper, and the Processor against it.
#include "cycle_loop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "../test_scenes.h"
#include "../windows.h"
#include "random_machine.h"
#include "simulation.h"
#include "timeline.h"

namespace pyrasim::hw {
namespace {

using Dates = std::vector<Cycle>;

/// The default latencies, two units, and rays of 3 cycles. The four corners leave the scan at 0 to 3 and reach the
/// generator (latency 4) at 1 to 4. Unit 0 starts the first at 1 + 4, the third when it is free again at 8; a sample
/// can be read 3 + 8 - 1 after its ray's start: unit 0's at 15 and 18, unit 1's at 16 and 19. The fourth completes
/// the pixel: from the classifier (latency 2) it comes to the colour unit at 21, from there (latency 1) to the
/// accumulator at 22, and to the frame buffer at 24.
TEST(CycleLoop, OnePixel) {
  MachineSpec spec;
  spec.intersection_units = 2;
  spec.intersection_cost.ray = 3;
  const Timeline expected{25,
                          {{"pixel_scan_to_view_vector_generator", {{0, 1, 2, 3}, {1, 2, 3, 4}}},
                           {"view_vector_generator_to_intersection_unit_0", {{1, 3}, {5, 8}}},
                           {"view_vector_generator_to_intersection_unit_1", {{2, 4}, {6, 9}}},
                           {"intersection_unit_0_to_pyramid_classifier", {{5, 8}, {15, 18}}},
                           {"intersection_unit_1_to_pyramid_classifier", {{6, 9}, {16, 19}}},
                           {"pyramid_classifier_to_color_unit", {{19}, {21}}},
                           {"color_unit_to_tree_accumulator", {{21}, {22}}},
                           {"tree_accumulator_to_frame_buffer", {{22}, {24}}},
                           {"tree_accumulator_to_pixel_scan", {{22}, {3}}}}};
  EXPECT_EQ(FirstDifference(run_cycle_loop(empty_scene(1, 1, 1), spec, 3), expected).text(), "");
}

/// Two pixels, all FIFOs of depth 1 and one slot. A cell read at t is free from t + 1: a token every other cycle. The
/// fifth corner takes the slot at 8. The sixth waits for it until the accumulator, at 13, has given it back.
TEST(CycleLoop, TwoPixelsWithOneSlotThroughSingleCells) {
  MachineSpec spec = with_all_fifos(quick_machine(), 1);
  spec.pixels_in_flight = 1;
  const Timeline expected{
      21,
      {{"pixel_scan_to_view_vector_generator", {{0, 2, 4, 6, 8, 14}, {1, 3, 5, 7, 9, 15}}},
       {"view_vector_generator_to_intersection_unit_0", {{1, 3, 5, 7, 9, 15}, {2, 4, 6, 8, 10, 16}}},
       {"intersection_unit_0_to_pyramid_classifier", {{2, 4, 6, 8, 10, 16}, {3, 5, 7, 9, 11, 17}}},
       {"pyramid_classifier_to_color_unit", {{11, 17}, {12, 18}}},
       {"color_unit_to_tree_accumulator", {{12, 18}, {13, 19}}},
       {"tree_accumulator_to_frame_buffer", {{13, 19}, {14, 20}}},
       {"tree_accumulator_to_pixel_scan", {{13, 19}, {8, 14}}}}};
  EXPECT_EQ(FirstDifference(run_cycle_loop(empty_scene(2, 1, 1), spec, 3), expected).text(), "");
}

/// Only the upper left corner of the pixel sees the sphere, so that the pixel is split, and of it the upper left
/// subpixel. The pixel's node leaves the classifier at 6, is accepted at 7 and issued at 8; its rays leave the
/// generator at 9 to 13 and arrive at 11 to 15. At 11 and 12 they are stored; at 13, 14, 15 and (without a ray) 16 the
/// subpixels are classified. The first goes to the controller: accepted at 14, issued at 15. The last closes the family
/// and is terminal: it goes to both. The second request's rays arrive at 18 to 22; its four subpixels are terminal at
/// 20 to 23.
TEST(CycleLoop, OnePixelSplitTwice) {
  Scene scene = empty_scene(1, 1, 1);
  scene.objects.push_back(object(Sphere{{10, 5, -5}, 1}));
  const Dates rays{1, 2, 3, 4, 9, 10, 11, 12, 13, 16, 17, 18, 19, 20};
  const Dates starts{2, 3, 4, 5, 10, 11, 12, 13, 14, 17, 18, 19, 20, 21};
  const Dates samples{3, 4, 5, 6, 11, 12, 13, 14, 15, 18, 19, 20, 21, 22};
  const Timeline expected{
      27,
      {{"pixel_scan_to_view_vector_generator", {{0, 1, 2, 3}, {1, 2, 3, 4}}},
       {"view_vector_generator_to_intersection_unit_0", {rays, starts}},
       {"intersection_unit_0_to_pyramid_classifier", {starts, samples}},
       {"pyramid_classifier_to_subdivision_controller", {{6, 13, 16}, {7, 14, 17}}},
       {"subdivision_controller_to_view_vector_generator", {{8, 15}, {9, 16}}},
       {"subdivision_controller_to_pyramid_classifier", {{8, 15}, {11, 18}}},
       {"pyramid_classifier_to_color_unit", {{14, 15, 16, 20, 21, 22, 23}, {15, 16, 17, 21, 22, 23, 24}}},
       {"color_unit_to_tree_accumulator", {{15, 16, 17, 21, 22, 23, 24}, {16, 17, 18, 22, 23, 24, 25}}},
       {"tree_accumulator_to_frame_buffer", {{25}, {26}}},
       {"tree_accumulator_to_pixel_scan", {{25}, {3}}}}};
  EXPECT_EQ(FirstDifference(run_cycle_loop(scene, quick_machine(), 2), expected).text(), "");
}

/// Two pixels of which only the upper left corner, the first ray, sees spheres: so many that there is a hierarchy,
/// which spares the other rays all of them. With these costs the first takes 1 + 10 cycles, the others 1.
Scene slow_first_ray() {
  Scene scene = empty_scene(2, 1, 1);
  for (int k = 0; k < 10; ++k) scene.objects.push_back(object(Sphere{{10, 5, -10}, 1 + 0.1 * k}));
  return scene;
}
MachineSpec first_free_machine() {
  MachineSpec spec = quick_machine();
  spec.intersection_units = 2;
  spec.dispatch = Dispatch::first_free;
  spec.intersection_cost.surface_test = {1, 0, 0};
  spec.fifos.view_vector_generator_to_intersection_unit = 1;
  return spec;
}

/// Unit 0 works on the first ray from 2 to 13, and the third waits in its FIFO. The fifth could go to unit 1 at 5 but
/// for the fourth, which is read only then: it goes at 6, after 5 found both full, and the sixth at 8. The classifier
/// reads in the order of issue, so that all but the first wait for the first, at 13.
TEST(CycleLoop, FirstFreePassesByASlowUnit) {
  const Timeline expected{
      22,
      {{"pixel_scan_to_view_vector_generator", {{0, 1, 2, 3, 4, 5}, {1, 2, 3, 4, 6, 8}}},
       {"view_vector_generator_to_intersection_unit_0", {{1, 3}, {2, 13}}},
       {"view_vector_generator_to_intersection_unit_1", {{2, 4, 6, 8}, {3, 5, 7, 9}}},
       {"view_vector_generator_to_pyramid_classifier", {{1, 2, 3, 4, 6, 8}, {13, 14, 15, 16, 17, 18}}},
       {"intersection_unit_0_to_pyramid_classifier", {{2, 13}, {13, 15}}},
       {"intersection_unit_1_to_pyramid_classifier", {{3, 5, 7, 9}, {14, 16, 17, 18}}},
       {"pyramid_classifier_to_color_unit", {{17, 18}, {18, 19}}},
       {"color_unit_to_tree_accumulator", {{18, 19}, {19, 20}}},
       {"tree_accumulator_to_frame_buffer", {{19, 20}, {20, 21}}},
       {"tree_accumulator_to_pixel_scan", {{19, 20}, {4, 5}}}}};
  EXPECT_EQ(FirstDifference(run_cycle_loop(slow_first_ray(), first_free_machine(), 0), expected).text(), "");
}

/// As before, but the issue-order queue is full with three rays under way: the fourth ray waits for its cell, which the
/// classifier reads at 13 and which is free from 14. By then both units are free, and the last three take turns.
TEST(CycleLoop, FirstFreeWaitsForRoomInTheReorderBuffer) {
  MachineSpec spec = first_free_machine();
  spec.issue_order_queue = 3;
  const Timeline expected{
      22,
      {{"pixel_scan_to_view_vector_generator", {{0, 1, 2, 3, 4, 5}, {1, 2, 3, 14, 15, 16}}},
       {"view_vector_generator_to_intersection_unit_0", {{1, 3, 15}, {2, 13, 16}}},
       {"view_vector_generator_to_intersection_unit_1", {{2, 14, 16}, {3, 15, 17}}},
       {"view_vector_generator_to_pyramid_classifier", {{1, 2, 3, 14, 15, 16}, {13, 14, 15, 16, 17, 18}}},
       {"intersection_unit_0_to_pyramid_classifier", {{2, 13, 16}, {13, 15, 17}}},
       {"intersection_unit_1_to_pyramid_classifier", {{3, 15, 17}, {14, 16, 18}}},
       {"pyramid_classifier_to_color_unit", {{17, 18}, {18, 19}}},
       {"color_unit_to_tree_accumulator", {{18, 19}, {19, 20}}},
       {"tree_accumulator_to_frame_buffer", {{19, 20}, {20, 21}}},
       {"tree_accumulator_to_pixel_scan", {{19, 20}, {4, 5}}}}};
  EXPECT_EQ(FirstDifference(run_cycle_loop(slow_first_ray(), spec, 0), expected).text(), "");
}

/// With one unit there is nothing to choose, and no issue-order queue to be full.
TEST(CycleLoop, FirstFreeWithOneUnitIsRoundRobin) {
  MachineSpec spec = quick_machine();
  spec.issue_order_queue = 1;
  const Timeline round_robin = run_cycle_loop(slow_first_ray(), spec, 2);
  spec.dispatch = Dispatch::first_free;
  EXPECT_EQ(FirstDifference(run_cycle_loop(slow_first_ray(), spec, 2), round_robin).text(), "");
}

/// What holds for first_free on every machine: nothing stands still, every ray has its number in the
/// issue-order queue at its own date, and every sample is read together with it.
TEST(CycleLoop, FirstFreeNumbersEveryRay) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const Scene scene = random_scene(random(), {10, 10, 0}, 6, 4);
    MachineSpec spec = random_machine(random, 3);
    spec.dispatch = Dispatch::first_free;
    Timeline timeline = run_cycle_loop(scene, spec, 3);
    EXPECT_EQ(timeline.fifos.contains("view_vector_generator_to_pyramid_classifier"), spec.intersection_units > 1);
    if (spec.intersection_units == 1) continue;
    FifoDates all;
    for (std::size_t k = 0; k < spec.intersection_units; ++k) {
      const std::string unit = "intersection_unit_" + std::to_string(k);
      const Dates& rays = timeline.fifos["view_vector_generator_to_" + unit].writes;
      const Dates& samples = timeline.fifos[unit + "_to_pyramid_classifier"].reads;
      all.writes.insert(all.writes.end(), rays.begin(), rays.end());
      all.reads.insert(all.reads.end(), samples.begin(), samples.end());
    }
    std::sort(all.writes.begin(), all.writes.end());
    std::sort(all.reads.begin(), all.reads.end());
    EXPECT_EQ(all, timeline.fifos["view_vector_generator_to_pyramid_classifier"]);
  }
}

/// For each seed; the preset `long` asks for more.
int machines_per_seed() {
  const char* const asked = std::getenv("PYRASIM_FUZZ_MACHINES");
  return asked == nullptr ? 10 : std::atoi(asked);
}

struct Case {
  Scene scene;
  MachineSpec spec;
  SimulationOptions options;
};

Case random_case(std::mt19937_64& random) {
  Case result;
  const auto columns = static_cast<int>(1 + random() % 12);
  const auto rows = static_cast<int>(1 + random() % 8);
  const int objects = random() % 8 == 0 ? 0 : 10;
  const int planes = random() % 4 == 0 ? 1 : 0;
  const int quadrics = random() % 3 == 0 ? 4 : 0;
  const int instances = random() % 3 == 0 ? 4 : 0;
  result.scene = random_scene(random(), {objects, objects, planes, 0, 0, quadrics, 0, instances}, columns, rows);
  if (random() % 2 == 0) result.scene = under_lights(std::move(result.scene), random);
  if (random() % 3 == 0) result.scene = with_textures(std::move(result.scene), random);
  result.options.max_level = static_cast<int>(random() % 6);
  if (random() % 4 == 0) result.options.formats.intersection = NumberFormat::single();
  if (random() % 4 == 0) result.options.formats.view_vectors = tf32;
  result.spec = random_machine(random, result.options.max_level);
  if (random() % 4 == 0) result.scene.camera.window = random_window(random, result.scene.camera.screen);
  return result;
}

class CycleLoopAndProcessor : public testing::TestWithParam<std::uint64_t> {};

TEST_P(CycleLoopAndProcessor, AgreeInEveryDateOfEveryFifo) {
  std::mt19937_64 random(GetParam());
  Simulation simulation;
  std::vector<Case> cases;
  std::deque<TimelineRecorder> decoupled;
  std::deque<TimelineRecorder> lockstep;
  for (int k = 0; k < machines_per_seed(); ++k) {
    Case& next = cases.emplace_back(random_case(random));
    decoupled.emplace_back(simulation.add(next.scene, next.spec, next.options));
    next.options.engine = Engine::lockstep;
    lockstep.emplace_back(simulation.add(next.scene, next.spec, next.options));
  }
  simulation.run();
  for (std::size_t k = 0; k < cases.size(); ++k) {
    SCOPED_TRACE("seed " + std::to_string(GetParam()) + ", machine " + std::to_string(k));
    const Case& its = cases[k];
    const Timeline loop = run_cycle_loop(its.scene, its.spec, its.options.max_level, its.options.formats);
    EXPECT_EQ(FirstDifference(loop, decoupled[k].timeline()).text(), "") << "cycle loop against decoupled";
    EXPECT_EQ(FirstDifference(loop, lockstep[k].timeline()).text(), "") << "cycle loop against lockstep";
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, CycleLoopAndProcessor, testing::Range<std::uint64_t>(1, 21),
                         [](const auto& test) { return std::to_string(test.param); });

}  // namespace
}  // namespace pyrasim::hw
