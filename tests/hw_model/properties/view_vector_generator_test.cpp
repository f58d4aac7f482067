// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "frames.h"
#include "pyramid/cell.h"

namespace pyrasim::hw {
namespace {

constexpr const char* corners = "pixel_scan_to_view_vector_generator";
constexpr const char* requests = "subdivision_controller_to_view_vector_generator";
constexpr const char* issue_order_queue = "view_vector_generator_to_pyramid_classifier";

/// Units that are often full.
MachineSpec first_free_machine(std::size_t units, std::size_t depth) {
  MachineSpec spec;
  spec.intersection_units = units;
  spec.dispatch = Dispatch::first_free;
  spec.fifos.view_vector_generator_to_intersection_unit = depth;
  return spec;
}

TEST(ViewVectorGenerator, ARayIsThereAfterTheLatencyAndNotBefore) {
  std::vector<Frame> frames;
  for (const Cycle latency : {1, 2, 9}) {
    frames.push_back({empty_scene(6, 4, 1), quick_machine()});
    frames.back().spec.view_vector_generator.latency = latency;
    frames.back().spec.intersection_units = 2;
  }
  for (const Dated& frame : dates_of(frames)) {
    SCOPED_TRACE(frame.name);
    for (const std::size_t unit : {0, 1}) {
      EXPECT_EQ(shortest_stay(frame.fifo(rays_to(unit))), frame.spec.view_vector_generator.latency);
    }
  }
}

TEST(ViewVectorGenerator, RaysLeaveAnIntervalApart) {
  std::vector<Frame> frames;
  for (const Cycle interval : {1, 2, 7}) {
    for (const std::size_t units : {1, 3}) {
      frames.push_back({empty_scene(6, 4, 1), quick_machine()});
      frames.back().spec.view_vector_generator.interval = interval;
      frames.back().spec.intersection_units = units;
    }
  }
  for (const Dated& frame : dates_of(frames)) {
    SCOPED_TRACE(frame.name);
    expect_gaps(sent_dates(frame), frame.spec.view_vector_generator.interval);
  }
}

TEST(ViewVectorGenerator, WaitsForRoomAndWritesTheCycleAfterTheRead) {
  std::vector<Frame> frames;
  for (const std::size_t depth : {1, 2, 5}) {
    frames.push_back({empty_scene(6, 4, 1), quick_machine()});
    frames.back().spec.intersection_cost.ray = 7;
    frames.back().spec.fifos.view_vector_generator_to_intersection_unit = depth;
  }
  for (const Dated& frame : dates_of(frames)) {
    SCOPED_TRACE(frame.name);
    expect_writes_as_soon_as_freed(frame.fifo(rays_to(0)), frame.spec.fifos.view_vector_generator_to_intersection_unit);
  }
}

TEST(ViewVectorGenerator, ARequestsFiveRaysStayTogether) {
  MachineSpec units = quick_machine();
  units.intersection_units = 3;
  for (const Dated& frame : dates_of({{scene_with_edges(), quick_machine(), 3}, {scene_with_edges(), units, 3}})) {
    SCOPED_TRACE(frame.name);
    const std::vector<Cycle> rays = sent_dates(frame);
    std::vector<Cycle> corners_or_requests;
    ASSERT_GT(frame.fifo(requests).reads.size(), 4U);
    auto corner = frame.fifo(corners).reads.begin();
    auto request = frame.fifo(requests).reads.begin();
    for (std::size_t k = 0; k < rays.size();) {
      const bool of_corner = corner != frame.fifo(corners).reads.end() && *corner == rays[k];
      if (of_corner) {
        ++corner;
        ++k;
        continue;
      }
      ASSERT_TRUE(request != frame.fifo(requests).reads.end());
      ASSERT_EQ(*request, rays[k]) << "ray " << k << " belongs to nothing that was read with it";
      ++request;
      k += subdivision_rays;  // were one of them a corner's, that corner would be missed in what follows
    }
    EXPECT_TRUE(corner == frame.fifo(corners).reads.end());
    EXPECT_TRUE(request == frame.fifo(requests).reads.end());
  }
}

/// A corner's ray leaves only where no request could be read, not even since that very cycle.
TEST(ViewVectorGenerator, ARequestGoesBeforeACornerOfTheSameDate) {
  MachineSpec slow = quick_machine();
  slow.view_vector_generator.interval = 2;
  for (const Dated& frame : dates_of({{scene_with_edges(), quick_machine(), 3}, {scene_with_edges(), slow, 3}})) {
    SCOPED_TRACE(frame.name);
    const FifoDates& request = frame.fifo(requests);
    const FifoDates& corner = frame.fifo(corners);
    const auto visible = [&](std::size_t n) {
      return n < request.writes.size() ? request.writes[n] + frame.spec.subdivision_controller.latency : never;
    };
    std::size_t next = 0;
    std::size_t ties = 0;
    for (std::size_t k = 0; k < corner.reads.size(); ++k) {
      for (; next < request.reads.size() && request.reads[next] < corner.reads[k]; ++next) {
        if (corner.writes[k] + frame.spec.pixel_scan.latency <= request.reads[next]) ++ties;
      }
      EXPECT_GT(visible(next), corner.reads[k]) << "corner " << k;
    }
    EXPECT_GT(ties, 0U);
  }
}

TEST(RoundRobin, DealsStrictlyInTurn) {
  std::vector<Frame> frames;
  for (const std::size_t units : {2, 3, 7}) {
    frames.push_back({scene_with_edges(), {}, 3});
    frames.back().spec.intersection_units = units;
    frames.back().spec.fifos.view_vector_generator_to_intersection_unit = 1;
  }
  for (const Dated& frame : dates_of(frames)) {
    SCOPED_TRACE(frame.name);
    const std::vector<RayDates> rays = rays_in_order(frame);
    for (std::size_t k = 0; k < rays.size(); ++k) ASSERT_EQ(rays[k].unit, k % frame.spec.intersection_units) << k;
  }
}

TEST(FirstFree, SkipsAUnitThatIsFullAtThatDateAndNoOther) {
  std::vector<Frame> frames;
  for (const std::size_t units : {2, 3, 5}) {
    for (const std::size_t depth : {1, 2}) {
      frames.push_back({scene_with_edges(), first_free_machine(units, depth), 3});
    }
  }
  for (const Dated& frame : dates_of(frames)) {
    SCOPED_TRACE(frame.name);
    const std::size_t depth = frame.spec.fifos.view_vector_generator_to_intersection_unit;
    std::vector<std::size_t> sent(frame.spec.intersection_units, 0);
    const auto room = [&](std::size_t unit) { return room_for(frame.fifo(rays_to(unit)), sent[unit], depth); };
    std::size_t unit = 0;
    std::size_t skipped = 0;
    for (const RayDates& ray : rays_in_order(frame)) {
      for (; unit != ray.unit; unit = (unit + 1) % sent.size(), ++skipped) ASSERT_GT(room(unit), ray.sent);
      ASSERT_LE(room(unit), ray.sent);
      ++sent[unit];
      unit = (unit + 1) % sent.size();
    }
    EXPECT_GT(skipped, 0U);
  }
}

/// A frame of corners alone: each ray leaves in the first cycle in which all that it needs is there.
TEST(FirstFree, WaitsForTheFirstUnitWithRoomAndNoLonger) {
  std::vector<Frame> frames;
  for (const std::size_t size : {2, 32}) {
    frames.push_back({random_scene(22, {30, 30, 0}, 12, 9), first_free_machine(3, 1)});
    frames.back().spec.issue_order_queue = size;
  }
  for (const Dated& frame : dates_of(frames)) {
    SCOPED_TRACE(frame.name);
    std::vector<std::size_t> sent(frame.spec.intersection_units, 0);
    const std::vector<RayDates> rays = rays_in_order(frame);
    Cycle ready = 0;
    for (std::size_t k = 0; k < rays.size(); ++k) {
      Cycle first_room = never;
      for (std::size_t unit = 0; unit < sent.size(); ++unit) {
        first_room = std::min(first_room, room_for(frame.fifo(rays_to(unit)), sent[unit], 1));
      }
      const Cycle corner = frame.fifo(corners).writes[k] + frame.spec.pixel_scan.latency;
      const Cycle number = room_for(frame.fifo(issue_order_queue), k, frame.spec.issue_order_queue);
      ASSERT_EQ(rays[k].sent, std::max({ready, corner, first_room, number})) << "ray " << k;
      ready = rays[k].sent + frame.spec.view_vector_generator.interval;
      ++sent[rays[k].unit];
    }
  }
}

TEST(FirstFree, HasAtMostSoManyRaysUnderWayAsTheReorderBufferHolds) {
  std::vector<Frame> frames;
  for (const std::size_t size : {1, 2, 6}) {
    frames.push_back({scene_with_edges(), first_free_machine(4, 8), 3});
    frames.back().spec.issue_order_queue = size;
  }
  for (const Dated& frame : dates_of(frames)) {
    SCOPED_TRACE(frame.name);
    const std::vector<RayDates> rays = rays_in_order(frame);
    std::size_t classified = 0;
    std::size_t most = 0;
    for (std::size_t k = 0; k < rays.size(); ++k) {
      while (rays[classified].classified < rays[k].sent) ++classified;
      most = std::max(most, k + 1 - classified);
    }
    EXPECT_EQ(most, frame.spec.issue_order_queue);
  }
}

}  // namespace
}  // namespace pyrasim::hw
