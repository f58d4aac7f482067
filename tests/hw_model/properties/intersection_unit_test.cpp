// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "frames.h"

namespace pyrasim::hw {
namespace {

/// The cells that the sample takes and the ray's work, 3 cycles, come before the latency.
TEST(IntersectionUnit, ASampleIsThereAfterWorkAndLatencyAndNotBefore) {
  std::vector<Frame> frames;
  for (const Cycle latency : {1, 2, 9}) {
    frames.push_back({empty_scene(6, 4, 1), quick_machine()});
    frames.back().spec.intersection_cost.ray = 3;
    frames.back().spec.intersection_latency = latency;
  }
  for (const Dated& frame : dates_of(frames)) {
    SCOPED_TRACE(frame.name);
    EXPECT_EQ(shortest_stay(frame.fifo(samples_of(0))), 3 + frame.spec.intersection_latency - 1);
  }
}

TEST(IntersectionUnit, RaysOfTheSameWorkStartThatWorkApart) {
  std::vector<Frame> frames;
  for (const Cycle work : {1, 2, 7}) {
    frames.push_back({empty_scene(6, 4, 1), quick_machine()});
    frames.back().spec.intersection_cost.ray = work;
  }
  for (const Dated& frame : dates_of(frames)) {
    SCOPED_TRACE(frame.name);
    expect_gaps(frame.fifo(rays_to(0)).reads, frame.spec.intersection_cost.ray);
  }
}

TEST(IntersectionUnit, TakesTheSamplesCellWhenTheRayStarts) {
  MachineSpec spec;
  spec.intersection_units = 3;
  for (const Dated& frame : dates_of({{scene_with_edges(), spec, 3}})) {
    SCOPED_TRACE(frame.name);
    for (const std::size_t unit : {0, 1, 2}) {
      EXPECT_EQ(frame.fifo(samples_of(unit)).writes, frame.fifo(rays_to(unit)).reads);
    }
  }
}

TEST(IntersectionUnit, WaitsForRoomAndStartsTheCycleAfterTheRead) {
  std::vector<Frame> frames;
  for (const std::size_t depth : {1, 2, 5}) {
    frames.push_back({empty_scene(6, 4, 1), quick_machine()});
    frames.back().spec.pyramid_classifier.interval = 7;
    frames.back().spec.fifos.intersection_unit_to_pyramid_classifier = depth;
  }
  for (const Dated& frame : dates_of(frames)) {
    SCOPED_TRACE(frame.name);
    expect_writes_as_soon_as_freed(frame.fifo(samples_of(0)), frame.spec.fifos.intersection_unit_to_pyramid_classifier);
  }
}

}  // namespace
}  // namespace pyrasim::hw
