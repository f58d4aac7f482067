// SPDX-License-Identifier: Apache-2.0
// What holds for every FIFO of every machine, from its dates.
#include <gtest/gtest.h>

#include <functional>

#include "../random_machine.h"
#include "frames.h"

namespace pyrasim::hw {
namespace {

std::vector<Frame> random_frames() {
  std::mt19937_64 random(2024);
  std::vector<Frame> frames;
  for (int k = 0; k < 30; ++k) {
    const int max_level = static_cast<int>(random() % 5);
    frames.push_back({random_scene(random(), {10, 10, 0}, 6, 5), random_machine(random, max_level), max_level});
  }
  return frames;
}

bool starts_with(const std::string& text, const std::string& begin) { return text.rfind(begin, 0) == 0; }

/// Of the stage that writes the FIFO.
Cycle least_latency(const MachineSpec& spec, const std::string& fifo) {
  if (starts_with(fifo, "pixel_scan")) return spec.pixel_scan.latency;
  if (starts_with(fifo, "view_vector_generator")) return spec.view_vector_generator.latency;
  if (starts_with(fifo, "intersection_unit")) return spec.intersection_cost.ray - 1 + spec.intersection_latency;
  if (starts_with(fifo, "pyramid_classifier")) return spec.pyramid_classifier.latency;
  if (starts_with(fifo, "subdivision_controller")) return spec.subdivision_controller.latency;
  if (starts_with(fifo, "color_unit")) return spec.color_unit.latency;
  return spec.tree_accumulator.latency;
}

std::size_t depth_of(const MachineSpec& spec, const std::string& fifo) {
  const FifoDepths& depths = spec.fifos;
  if (starts_with(fifo, "pixel_scan_to")) return depths.pixel_scan_to_view_vector_generator;
  if (starts_with(fifo, "view_vector_generator_to_i")) return depths.view_vector_generator_to_intersection_unit;
  if (starts_with(fifo, "view_vector_generator_to_p")) return spec.issue_order_queue;
  if (starts_with(fifo, "intersection_unit")) return depths.intersection_unit_to_pyramid_classifier;
  if (starts_with(fifo, "pyramid_classifier_to_s")) return depths.pyramid_classifier_to_subdivision_controller;
  if (starts_with(fifo, "pyramid_classifier_to_c")) return depths.pyramid_classifier_to_color_unit;
  if (starts_with(fifo, "color_unit")) return depths.color_unit_to_tree_accumulator;
  if (starts_with(fifo, "subdivision_controller_to_v")) return depths.subdivision_controller_to_view_vector_generator;
  if (starts_with(fifo, "subdivision_controller_to_p")) return depths.subdivision_controller_to_pyramid_classifier;
  if (starts_with(fifo, "tree_accumulator_to_f")) return depths.tree_accumulator_to_frame_buffer;
  return spec.pixels_in_flight;
}

using Property = std::function<void(const MachineSpec&, const std::string& fifo, const FifoDates&)>;

void for_every_fifo(const Property& property) {
  for (const Dated& frame : dates_of(random_frames())) {
    for (const auto& [fifo, dates] : frame.timeline.fifos) {
      SCOPED_TRACE(frame.name + ", " + fifo);
      property(frame.spec, fifo, dates);
    }
  }
}

TEST(EveryFifo, NoTokenIsReadBeforeTheLatencyIsOver) {
  for_every_fifo([](const MachineSpec& spec, const std::string& fifo, const FifoDates& dates) {
    const bool slots = fifo == "tree_accumulator_to_pixel_scan";
    EXPECT_GE(shortest_stay(dates, slots ? spec.pixels_in_flight : 0), least_latency(spec, fifo));
  });
}

TEST(EveryFifo, NoCellIsWrittenAgainBeforeItHasBeenRead) {
  for_every_fifo([](const MachineSpec& spec, const std::string& fifo, const FifoDates& dates) {
    // Of the slots all cells are full at first: the first write needs the first read.
    const std::size_t depth = fifo == "tree_accumulator_to_pixel_scan" ? 0 : depth_of(spec, fifo);
    const std::vector<Cycle> writes = rewritten(dates, depth);
    const std::vector<Cycle> least = freed(dates, depth);
    ASSERT_EQ(writes.size(), least.size());
    for (std::size_t n = 0; n < writes.size(); ++n) ASSERT_GE(writes[n], least[n]) << "write " << n + depth;
  });
}

TEST(EveryFifo, WritesAndReadsEachAscend) {
  for_every_fifo([](const MachineSpec&, const std::string&, const FifoDates& dates) {
    EXPECT_GE(least_gap(dates.writes), 1U);
    EXPECT_GE(least_gap(dates.reads), 1U);
  });
}

TEST(EveryFifo, ButThatOfTheSlotsIsEmptyInTheEnd) {
  for_every_fifo([](const MachineSpec&, const std::string& fifo, const FifoDates& dates) {
    if (fifo != "tree_accumulator_to_pixel_scan") {
      EXPECT_EQ(dates.writes.size(), dates.reads.size());
    }
  });
}

}  // namespace
}  // namespace pyrasim::hw
