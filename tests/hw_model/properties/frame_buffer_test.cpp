// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "frames.h"

namespace pyrasim::hw {
namespace {

constexpr const char* pixels = "tree_accumulator_to_frame_buffer";

std::vector<Frame> frames_of_intervals() {
  std::vector<Frame> frames;
  for (const Cycle interval : {2, 3, 7}) {
    frames.push_back({empty_scene(6, 4, 1), quick_machine()});
    frames.back().spec.frame_buffer_interval = interval;
  }
  return frames;
}

TEST(FrameBuffer, PixelsAreReadAnIntervalApart) {
  for (const Dated& frame : dates_of(frames_of_intervals())) {
    SCOPED_TRACE(frame.name);
    expect_gaps(frame.fifo(pixels).reads, frame.spec.frame_buffer_interval);
  }
}

TEST(FrameBuffer, TheFrameEndsAnIntervalAfterTheLastPixel) {
  for (const Dated& frame : dates_of(frames_of_intervals())) {
    SCOPED_TRACE(frame.name);
    EXPECT_EQ(frame.timeline.cycles, frame.fifo(pixels).reads.back() + frame.spec.frame_buffer_interval);
  }
}

}  // namespace
}  // namespace pyrasim::hw
