// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "frames.h"

namespace pyrasim::hw {
namespace {

constexpr const char* terminal_nodes = "pyramid_classifier_to_color_unit";
constexpr const char* colors = "color_unit_to_tree_accumulator";

TEST(ColorUnit, AColourIsThereAfterTheLatencyAndNotBefore) {
  std::vector<Frame> frames;
  for (const Cycle latency : {1, 2, 9}) {
    frames.push_back({scene_with_edges(), quick_machine(), 3});
    frames.back().spec.color_unit.latency = latency;
  }
  for (const Dated& frame : dates_of(frames)) {
    SCOPED_TRACE(frame.name);
    EXPECT_EQ(shortest_stay(frame.fifo(colors)), frame.spec.color_unit.latency);
  }
}

TEST(ColorUnit, NodesAreReadAnIntervalApart) {
  std::vector<Frame> frames;
  for (const Cycle interval : {2, 3, 7}) {
    frames.push_back({empty_scene(6, 4, 1), quick_machine()});
    frames.back().spec.color_unit.interval = interval;
  }
  for (const Dated& frame : dates_of(frames)) {
    SCOPED_TRACE(frame.name);
    expect_gaps(frame.fifo(terminal_nodes).reads, frame.spec.color_unit.interval);
  }
}

/// Pixels of case 1 and 2 as well as subpixels: one node read, its colour written in the same firing.
TEST(ColorUnit, EveryNodePassesThrough) {
  for (const Dated& frame : dates_of({{scene_with_edges(), quick_machine(), 3}})) {
    SCOPED_TRACE(frame.name);
    const std::vector<Cycle>& nodes = frame.fifo(terminal_nodes).reads;
    EXPECT_EQ(nodes.size(), frame.fifo(terminal_nodes).writes.size());
    EXPECT_EQ(frame.fifo(colors).writes, nodes);
    EXPECT_GT(nodes.size(), frame.fifo("tree_accumulator_to_frame_buffer").writes.size());
  }
}

TEST(ColorUnit, WaitsForRoomAndWritesTheCycleAfterTheRead) {
  std::vector<Frame> frames;
  for (const std::size_t depth : {2, 3, 5}) {
    frames.push_back({empty_scene(6, 4, 1), quick_machine()});
    frames.back().spec.tree_accumulator.interval = 7;
    frames.back().spec.fifos.color_unit_to_tree_accumulator = depth;
  }
  for (const Dated& frame : dates_of(frames)) {
    SCOPED_TRACE(frame.name);
    expect_writes_as_soon_as_freed(frame.fifo(colors), frame.spec.fifos.color_unit_to_tree_accumulator);
  }
}

}  // namespace
}  // namespace pyrasim::hw
