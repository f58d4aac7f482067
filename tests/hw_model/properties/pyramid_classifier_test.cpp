// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "frames.h"
#include "hw_model/processor.h"

namespace pyrasim::hw {
namespace {

constexpr const char* terminal_nodes = "pyramid_classifier_to_color_unit";
constexpr const char* nodes_to_split = "pyramid_classifier_to_subdivision_controller";
constexpr const char* parents = "subdivision_controller_to_pyramid_classifier";

TEST(PyramidClassifier, ANodeIsThereAfterTheLatencyAndNotBefore) {
  std::vector<Frame> frames;
  for (const Cycle latency : {1, 2, 9}) {
    frames.push_back({scene_with_edges(), quick_machine(), 3});
    frames.back().spec.pyramid_classifier.latency = latency;
  }
  for (const Dated& frame : dates_of(frames)) {
    SCOPED_TRACE(frame.name);
    EXPECT_EQ(shortest_stay(frame.fifo(terminal_nodes)), frame.spec.pyramid_classifier.latency);
    EXPECT_EQ(shortest_stay(frame.fifo(nodes_to_split)), frame.spec.pyramid_classifier.latency);
  }
}

TEST(PyramidClassifier, SamplesAreReadAnIntervalApart) {
  std::vector<Frame> frames;
  for (const Cycle interval : {1, 2, 7}) {
    frames.push_back({empty_scene(6, 4, 1), quick_machine()});
    frames.back().spec.pyramid_classifier.interval = interval;
  }
  for (const Dated& frame : dates_of(frames)) {
    SCOPED_TRACE(frame.name);
    expect_gaps(frame.fifo(samples_of(0)).reads, frame.spec.pyramid_classifier.interval);
  }
}

TEST(PyramidClassifier, WaitsForRoomAndWritesTheCycleAfterTheRead) {
  std::vector<Frame> frames;
  for (const std::size_t depth : {2, 3, 5}) {
    frames.push_back({empty_scene(6, 4, 1), quick_machine()});
    frames.back().spec.color_unit.interval = 7;
    frames.back().spec.fifos.pyramid_classifier_to_color_unit = depth;
  }
  for (const Dated& frame : dates_of(frames)) {
    SCOPED_TRACE(frame.name);
    expect_writes_as_soon_as_freed(frame.fifo(terminal_nodes), frame.spec.fifos.pyramid_classifier_to_color_unit);
  }
}

TEST(PyramidClassifier, ReadsSamplesInTheOrderOfIssueThoughUnitsFinishOutOfOrder) {
  std::vector<Frame> frames;
  for (const Dispatch dispatch : {Dispatch::round_robin, Dispatch::first_free}) {
    frames.push_back({scene_with_edges(), {}, 3});
    frames.back().spec.dispatch = dispatch;
    frames.back().spec.intersection_units = 3;
    frames.back().spec.fifos.view_vector_generator_to_intersection_unit = 2;
  }
  for (const Dated& frame : dates_of(frames)) {
    SCOPED_TRACE(frame.name);
    const std::vector<RayDates> rays = rays_in_order(frame);
    std::size_t out_of_order = 0;
    for (std::size_t k = 1; k < rays.size(); ++k) {
      if (rays[k].started < rays[k - 1].started) ++out_of_order;
      ASSERT_GT(rays[k].classified, rays[k - 1].classified) << "ray " << k;
    }
    EXPECT_GT(out_of_order, 0U);
  }
}

/// Neither a sample nor, where units are chosen, a unit's number is there before the first ray: nothing is known yet.
TEST(PyramidClassifier, CannotFireBeforeItsFirstSample) {
  for (const Dispatch dispatch : {Dispatch::round_robin, Dispatch::first_free}) {
    MachineSpec spec;
    spec.dispatch = dispatch;
    const Processor machine(dispatch == Dispatch::first_free ? "first_free" : "round_robin", scene_with_edges(), spec,
                            {});
    for (const Stage* stage : machine.stages()) {
      EXPECT_EQ(stage->next_start().known(), stage->basename() == std::string("pixel_scan")) << stage->name();
    }
  }
}

TEST(PyramidClassifier, ReadsAUnitsNumberTogetherWithItsSample) {
  MachineSpec spec;
  spec.dispatch = Dispatch::first_free;
  for (const Dated& frame : dates_of({{scene_with_edges(), spec, 3}})) {
    SCOPED_TRACE(frame.name);
    std::vector<Cycle> samples;
    for (const RayDates& ray : rays_in_order(frame)) samples.push_back(ray.classified);
    EXPECT_EQ(frame.fifo("view_vector_generator_to_pyramid_classifier").reads, samples);
  }
}

/// The first of a request's samples is read with the parent; after the fifth follows a firing that reads none.
TEST(PyramidClassifier, ReadsAParentWithTheFirstOfFiveSamplesAndNoSampleInTheSixthFiring) {
  for (const Dated& frame : dates_of({{scene_with_edges(), quick_machine(), 3}})) {
    SCOPED_TRACE(frame.name);
    const std::vector<Cycle>& samples = frame.fifo(samples_of(0)).reads;
    const std::vector<Cycle> nodes = merged(frame.fifo(terminal_nodes).writes, frame.fifo(nodes_to_split).writes);
    ASSERT_GT(frame.fifo(parents).reads.size(), 4U);
    for (const Cycle at : frame.fifo(parents).reads) {
      const auto first = std::find(samples.begin(), samples.end(), at);
      ASSERT_TRUE(samples.end() - first >= 5) << at;
      const Cycle fifth = *(first + 4);
      const auto sixth = std::upper_bound(nodes.begin(), nodes.end(), fifth);
      ASSERT_TRUE(sixth != nodes.end());
      EXPECT_FALSE(std::binary_search(samples.begin(), samples.end(), *sixth)) << *sixth;
    }
  }
}

}  // namespace
}  // namespace pyrasim::hw
