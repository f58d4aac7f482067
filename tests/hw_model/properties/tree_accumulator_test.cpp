// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "frames.h"

namespace pyrasim::hw {
namespace {

constexpr const char* colors = "color_unit_to_tree_accumulator";
constexpr const char* pixels = "tree_accumulator_to_frame_buffer";
constexpr const char* slots = "tree_accumulator_to_pixel_scan";

TEST(TreeAccumulator, APixelIsThereAfterTheLatencyAndNotBefore) {
  std::vector<Frame> frames;
  for (const Cycle latency : {1, 2, 9}) {
    frames.push_back({empty_scene(6, 4, 1), quick_machine()});
    frames.back().spec.tree_accumulator.latency = latency;
  }
  for (const Dated& frame : dates_of(frames)) {
    SCOPED_TRACE(frame.name);
    EXPECT_EQ(shortest_stay(frame.fifo(pixels)), frame.spec.tree_accumulator.latency);
  }
}

/// With one slot the scan waits for it, and takes it in the very cycle in which it is back.
TEST(TreeAccumulator, ASlotIsBackTheLatencyAfterThePixelsLastNode) {
  std::vector<Frame> frames;
  for (const Cycle latency : {1, 2, 9}) {
    frames.push_back({scene_with_edges(), quick_machine(), 3});
    frames.back().spec.tree_accumulator.latency = latency;
    frames.back().spec.pixels_in_flight = 1;
  }
  for (const Dated& frame : dates_of(frames)) {
    SCOPED_TRACE(frame.name);
    const std::vector<Cycle>& nodes = frame.fifo(colors).reads;
    const FifoDates& slot = frame.fifo(slots);
    ASSERT_EQ(slot.writes.size(), slot.reads.size());
    for (std::size_t k = 0; k < slot.writes.size(); ++k) {
      // One pixel at a time: its last node is the last that is read before the next pixel begins.
      const Cycle next_begins = k + 1 < slot.reads.size() ? slot.reads[k + 1] : frame.timeline.cycles;
      ASSERT_EQ(slot.writes[k], *(std::lower_bound(nodes.begin(), nodes.end(), next_begins) - 1)) << "pixel " << k;
      if (k + 1 < slot.reads.size()) {
        ASSERT_EQ(next_begins, slot.writes[k] + frame.spec.tree_accumulator.latency) << "pixel " << k;
      }
    }
  }
}

TEST(TreeAccumulator, GivesBackTheSlotWithThePixel) {
  for (const Dated& frame : dates_of({{scene_with_edges(), quick_machine(), 3}})) {
    SCOPED_TRACE(frame.name);
    EXPECT_EQ(frame.fifo(slots).writes, frame.fifo(pixels).writes);
  }
}

TEST(TreeAccumulator, NodesAreReadAnIntervalApart) {
  std::vector<Frame> frames;
  for (const Cycle interval : {2, 3, 7}) {
    frames.push_back({empty_scene(6, 4, 1), quick_machine()});
    frames.back().spec.tree_accumulator.interval = interval;
  }
  for (const Dated& frame : dates_of(frames)) {
    SCOPED_TRACE(frame.name);
    expect_gaps(frame.fifo(colors).reads, frame.spec.tree_accumulator.interval);
  }
}

TEST(TreeAccumulator, WaitsForRoomAndWritesTheCycleAfterTheRead) {
  std::vector<Frame> frames;
  for (const std::size_t depth : {2, 3, 5}) {
    frames.push_back({empty_scene(6, 4, 1), quick_machine()});
    frames.back().spec.frame_buffer_interval = 7;
    frames.back().spec.fifos.tree_accumulator_to_frame_buffer = depth;
  }
  for (const Dated& frame : dates_of(frames)) {
    SCOPED_TRACE(frame.name);
    expect_writes_as_soon_as_freed(frame.fifo(pixels), frame.spec.fifos.tree_accumulator_to_frame_buffer);
  }
}

}  // namespace
}  // namespace pyrasim::hw
