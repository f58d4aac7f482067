// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "frames.h"

namespace pyrasim::hw {
namespace {

constexpr const char* corners = "pixel_scan_to_view_vector_generator";
constexpr const char* slots = "tree_accumulator_to_pixel_scan";

TEST(PixelScan, ACornerIsThereAfterTheLatencyAndNotBefore) {
  std::vector<Frame> frames;
  for (const Cycle latency : {1, 2, 9}) {
    frames.push_back({empty_scene(6, 4, 1), quick_machine()});
    frames.back().spec.pixel_scan.latency = latency;
  }
  for (const Dated& frame : dates_of(frames)) {
    SCOPED_TRACE(frame.name);
    EXPECT_EQ(shortest_stay(frame.fifo(corners)), frame.spec.pixel_scan.latency);
  }
}

TEST(PixelScan, CornersLeaveAnIntervalApart) {
  std::vector<Frame> frames;
  for (const Cycle interval : {1, 2, 7}) {
    frames.push_back({empty_scene(6, 4, 1), quick_machine()});
    frames.back().spec.pixel_scan.interval = interval;
  }
  for (const Dated& frame : dates_of(frames)) {
    SCOPED_TRACE(frame.name);
    EXPECT_EQ(frame.fifo(corners).writes.front(), 0U);
    expect_gaps(frame.fifo(corners).writes, frame.spec.pixel_scan.interval);
  }
}

TEST(PixelScan, WaitsForRoomAndWritesTheCycleAfterTheRead) {
  std::vector<Frame> frames;
  for (const std::size_t depth : {1, 2, 5}) {
    frames.push_back({empty_scene(6, 4, 1), quick_machine()});
    frames.back().spec.view_vector_generator.interval = 7;
    frames.back().spec.fifos.pixel_scan_to_view_vector_generator = depth;
  }
  for (const Dated& frame : dates_of(frames)) {
    SCOPED_TRACE(frame.name);
    expect_writes_as_soon_as_freed(frame.fifo(corners), frame.spec.fifos.pixel_scan_to_view_vector_generator);
  }
}

TEST(PixelScan, TakesASlotForEachLowerRightCornerAndForNoOther) {
  const int columns = 6;
  const int rows = 4;
  for (const Dated& frame : dates_of({{empty_scene(columns, rows, 1), quick_machine()}})) {
    SCOPED_TRACE(frame.name);
    std::vector<Cycle> expected;
    for (int row = 1; row <= rows; ++row) {
      for (int column = 1; column <= columns; ++column) {
        expected.push_back(frame.fifo(corners).writes[static_cast<std::size_t>(row * (columns + 1) + column)]);
      }
    }
    EXPECT_EQ(frame.fifo(slots).reads, expected);
  }
}

TEST(PixelScan, HasAtMostSoManyPixelsInFlightAsThereAreSlots) {
  std::vector<Frame> frames;
  for (const std::size_t pixels : {1, 2, 5}) {
    frames.push_back({scene_with_edges(), quick_machine(), 3});
    frames.back().spec.pixels_in_flight = pixels;
  }
  for (const Dated& frame : dates_of(frames)) {
    SCOPED_TRACE(frame.name);
    const FifoDates& dates = frame.fifo(slots);
    std::size_t most = 0;
    std::size_t finished = 0;
    for (std::size_t begun = 1; begun <= dates.reads.size(); ++begun) {
      // A pixel's slot is in use until the scan can read it again.
      while (finished < dates.writes.size() &&
             dates.writes[finished] + frame.spec.tree_accumulator.latency <= dates.reads[begun - 1])
        ++finished;
      most = std::max(most, begun - finished);
    }
    EXPECT_EQ(most, frame.spec.pixels_in_flight);
  }
}

}  // namespace
}  // namespace pyrasim::hw
