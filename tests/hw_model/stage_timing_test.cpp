// SPDX-License-Identifier: Apache-2.0
// One property of the stages' timing each.
#include <gtest/gtest.h>

#include "../test_scenes.h"
#include "simulation.h"

namespace pyrasim::hw {
namespace {

SimulationOptions at_level(int max_level) {
  SimulationOptions options;
  options.max_level = max_level;
  return options;
}

Cycle cost_of(const IntersectionCost& cost, const FrameStatistics& statistics) {
  Cycle sum = cost.ray * statistics.total_rays() + cost.box_test * statistics.work.box_tests;
  for (std::size_t k = 0; k < surface_kinds; ++k) sum += cost.surface_test[k] * statistics.work.surface_tests[k];
  return sum;
}

/// A 1 x 1 frame of the empty scene on the default latencies, worked out by hand. The pixel scan writes its four
/// corners at 0, 1, 2 and 3 (latency 1). The generator sends the last at 4 (latency 4), a unit takes it at 8 and is
/// busy for 1 cycle (latency 8): visible at 16. The classifier (latency 2) sends the node at 16, the colour unit
/// (latency 1) its colour at 18, the accumulator (latency 2) the pixel at 19, and the frame buffer stores it at 21,
/// which takes the cycle to 22.
TEST(FrameLatency, OfOnePixelByHand) {
  Simulation simulation;
  const Scene scene = empty_scene(1, 1, 0.5);
  MachineSpec one_unit;
  one_unit.intersection_units = 1;
  const Processor& four = simulation.add(scene, {}, at_level(0));
  const Processor& one = simulation.add(scene, one_unit, at_level(0));
  // Each latency that is longer by d makes the frame longer by d.
  MachineSpec longer;
  longer.pixel_scan.latency += 3;
  longer.view_vector_generator.latency += 10;
  longer.intersection_latency += 20;
  longer.pyramid_classifier.latency += 40;
  longer.color_unit.latency += 160;
  longer.tree_accumulator.latency += 80;
  longer.frame_buffer_interval += 7;
  const Processor& slow = simulation.add(scene, longer, at_level(0));
  simulation.run();
  EXPECT_EQ(four.cycles(), 22U);
  EXPECT_EQ(one.cycles(), 22U);
  EXPECT_EQ(slow.cycles(), 22U + 3 + 10 + 20 + 40 + 160 + 80 + 7);
  const StageStatistics buffer = stage_statistics(four, "frame_buffer");
  EXPECT_EQ(buffer.busy, 1U);
  EXPECT_EQ(buffer.idle, 21U);
  const StageStatistics scan = stage_statistics(four, "pixel_scan");
  EXPECT_EQ(scan.busy, 4U);
  EXPECT_EQ(scan.idle, 18U);
}

/// One plane in front of the camera: every ray costs ray + plane cycles, and a lone unit is what the frame waits for.
TEST(IntersectionUnit, OccupancyIsTheCostOfItsWork) {
  Scene plane = empty_scene(6, 5, 0.125);
  plane.objects = {object(Plane{{1, 0, 0}, 3})};
  const Scene mixed = random_scene(5, {20, 20, 2, 6, 6, 8}, 16, 12);
  MachineSpec spec;
  spec.intersection_units = 1;
  spec.intersection_cost = {5, 3, {7, 11, 13}};
  Simulation simulation;
  const Processor& on_plane = simulation.add(plane, spec, at_level(0));
  const Processor& on_mixed = simulation.add(mixed, spec, at_level(3));
  simulation.run();
  EXPECT_EQ(stage_statistics(on_plane, "intersection_unit_0").busy, 42U * (5 + 11));
  // 42 rays one after the other: the first starts at 5, and the last is followed by 8 + 2 + 1 + 2 + 1 cycles less
  // 1.
  EXPECT_EQ(on_plane.cycles(), 5 + 42U * 16 + 13);
  const StageStatistics unit = stage_statistics(on_mixed, "intersection_unit_0");
  EXPECT_EQ(unit.busy, cost_of(spec.intersection_cost, on_mixed.statistics()));
  EXPECT_EQ(unit.firings, on_mixed.statistics().total_rays());
  EXPECT_LE(unit.busy, on_mixed.cycles());
}

TEST(IntersectionUnit, UnitsShareTheWorkInTurn) {
  const Scene scene = random_scene(6, {20, 20, 0}, 16, 12);
  MachineSpec spec;
  spec.intersection_units = 5;
  Simulation simulation;
  const Processor& machine = simulation.add(scene, spec, at_level(3));
  simulation.run();
  const std::uint64_t rays = machine.statistics().total_rays();
  Cycle busy = 0;
  for (std::uint64_t k = 0; k < 5; ++k) {
    const StageStatistics unit = stage_statistics(machine, "intersection_unit_" + std::to_string(k));
    EXPECT_EQ(unit.firings, (rays + 4 - k) / 5);
    busy += unit.busy;
  }
  EXPECT_EQ(busy, cost_of(spec.intersection_cost, machine.statistics()));
}

/// A generator that takes c cycles a ray bounds the frame from below by c for each of them.
TEST(ViewVectorGenerator, IntervalBoundsTheFrame) {
  const Scene scene = random_scene(7, {10, 10, 0}, 12, 9);
  Simulation simulation;
  std::vector<const Processor*> machines;
  for (const Cycle interval : {1, 4, 9}) {
    MachineSpec spec;
    spec.intersection_units = 16;
    spec.view_vector_generator.interval = interval;
    machines.push_back(&simulation.add(scene, spec, at_level(2)));
  }
  simulation.run();
  const std::array<Cycle, 3> intervals{1, 4, 9};
  for (std::size_t k = 0; k < 3; ++k) {
    const StageStatistics generator = stage_statistics(*machines[k], "view_vector_generator");
    const std::uint64_t rays = machines[k]->statistics().total_rays();
    EXPECT_EQ(generator.firings, rays);
    EXPECT_EQ(generator.busy, rays * intervals[k]);
    EXPECT_GE(machines[k]->cycles(), rays * intervals[k]);
  }
}

/// Corners of the raster and families of six firings each (five samples, and the last subpixel).
TEST(PyramidClassifier, FiresOncePerCornerAndSixTimesPerSubdivision) {
  const Scene scene = random_scene(8, {10, 10, 0}, 12, 9);
  Simulation simulation;
  const Processor& machine = simulation.add(scene, {}, at_level(3));
  simulation.run();
  const FrameStatistics statistics = machine.statistics();
  EXPECT_EQ(stage_statistics(machine, "pyramid_classifier").firings, 13U * 10 + 6 * statistics.subdivisions);
  EXPECT_EQ(stage_statistics(machine, "color_unit").firings, statistics.terminal_nodes);
  EXPECT_EQ(stage_statistics(machine, "tree_accumulator").firings, statistics.terminal_nodes);
  EXPECT_EQ(stage_statistics(machine, "frame_buffer").firings, 12U * 9);
  EXPECT_EQ(stage_statistics(machine, "pixel_scan").firings, 13U * 10);
}

/// Without the loop, room and units can only help.
TEST(FeedForward, DeeperFifosAndMoreUnitsNeverCost) {
  const Scene scene = random_scene(9, {30, 30, 1}, 24, 18);
  const std::array<std::size_t FifoDepths::*, 6> fifos{
      &FifoDepths::pixel_scan_to_view_vector_generator,     &FifoDepths::view_vector_generator_to_intersection_unit,
      &FifoDepths::intersection_unit_to_pyramid_classifier, &FifoDepths::pyramid_classifier_to_color_unit,
      &FifoDepths::color_unit_to_tree_accumulator,          &FifoDepths::tree_accumulator_to_frame_buffer};
  Simulation simulation;
  std::vector<std::vector<const Processor*>> chains;
  for (const std::size_t base : {1, 3}) {
    for (const auto fifo : fifos) {
      auto& chain = chains.emplace_back();
      for (const std::size_t depth : {1, 2, 3, 4, 8, 64}) {
        MachineSpec spec = with_all_fifos({}, base);
        spec.fifos.*fifo = depth;
        spec.tree_accumulator.interval = 3;
        chain.push_back(&simulation.add(scene, spec, at_level(0)));
      }
    }
    auto& chain = chains.emplace_back();
    for (const std::size_t units : {1, 2, 3, 4, 5, 8, 13, 32}) {
      MachineSpec spec = with_all_fifos({}, base);
      spec.intersection_units = units;
      chain.push_back(&simulation.add(scene, spec, at_level(0)));
    }
  }
  simulation.run();
  for (const auto& chain : chains) {
    for (std::size_t k = 1; k < chain.size(); ++k) EXPECT_LE(chain[k]->cycles(), chain[k - 1]->cycles()) << k;
    for (const Processor* machine : chain) EXPECT_TRUE(machine->image().pixels() == chain[0]->image().pixels());
  }
}

}  // namespace
}  // namespace pyrasim::hw
