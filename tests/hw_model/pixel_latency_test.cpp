// SPDX-License-Identifier: Apache-2.0
// The latency of pixels, recomputed from dates: from the scan's sending of a pixel's last corner to its colour being
// visible to the frame buffer.
#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <vector>

#include "../test_scenes.h"
#include "random_machine.h"
#include "simulation.h"
#include "timeline.h"

namespace pyrasim::hw {
namespace {

/// A picture of one column, so that the machine reports after every pixel: which one it was is seen in the picture.
Scene column_of_pixels(std::uint64_t seed, int rows) {
  Scene scene = random_scene(seed, {12, 12, 0}, 16, rows);
  scene.camera.window = PixelWindow{8, 0, 1, rows};
  return scene;
}

/// One machine, its dates, and its pixels in the order in which they were finished.
class FinishingOrder {
 public:
  FinishingOrder(Simulation& simulation, const Scene& scene, const MachineSpec& spec, SimulationOptions options)
      : scene_(scene), spec_(spec), options_(options), seen_(static_cast<std::size_t>(scene.camera.rendered().rows)) {
    options.progress = [this](double) {
      note_new_pixels();
      return true;
    };
    machine_ = &simulation.add(scene, spec, options);
    recorder_ = std::make_unique<TimelineRecorder>(*machine_);
  }
  FinishingOrder(const FinishingOrder&) = delete;
  FinishingOrder& operator=(const FinishingOrder&) = delete;

  const Processor& machine() const { return *machine_; }
  bool out_of_order() const { return !std::is_sorted(order_.begin(), order_.end()); }

  std::vector<FinishedPixel> pixels() const {
    const Timeline timeline = recorder_->timeline();
    const std::vector<Cycle>& corners = timeline.fifos.at("pixel_scan_to_view_vector_generator").writes;
    const std::vector<Cycle>& colors = timeline.fifos.at("tree_accumulator_to_frame_buffer").writes;
    std::vector<FinishedPixel> result;
    for (std::size_t k = 0; k < order_.size(); ++k) {
      const std::size_t pixel = order_[k];
      const Cycle sent = corners.at(2 * (pixel + 1) + 1);  // two corners a row; its lower right one
      const Cycle visible = colors.at(k) + spec_.tree_accumulator.latency;
      result.push_back({static_cast<std::uint32_t>(pixel), deepest(static_cast<int>(pixel)), visible - sent});
    }
    return result;
  }

 private:
  void note_new_pixels() {
    for (std::size_t k = 0; k < seen_.size(); ++k) {
      if (seen_[k] || machine_->image().pixels()[k] == glm::vec3(0)) continue;  // no pixel of these scenes is black
      seen_[k] = true;
      order_.push_back(k);
    }
  }

  /// The deepest level that the reference renderer finds in a picture of that pixel alone.
  std::uint32_t deepest(int pixel) const {
    Scene alone = scene_;
    alone.camera.window = PixelWindow{8, pixel, 1, 1};
    const auto rays = reference(alone, options_.max_level).statistics.rays_by_level;
    std::uint32_t level = 0;
    while (level + 1 < rays.size() && rays[level + 1] > 0) ++level;
    return level;
  }

  Scene scene_;
  MachineSpec spec_;
  SimulationOptions options_;
  std::vector<bool> seen_;
  std::vector<std::size_t> order_;
  Processor* machine_ = nullptr;
  std::unique_ptr<TimelineRecorder> recorder_;
};

void expect_histograms(const Processor& machine, const std::vector<FinishedPixel>& pixels) {
  for (std::uint32_t level = 0; level <= max_level_limit; ++level) {
    LatencyHistogram expected;
    for (const FinishedPixel& pixel : pixels) {
      if (pixel.deepest == level) expected.add(pixel.latency);
    }
    const LatencyHistogram& histogram = machine.tree_accumulator().latencies()[level];
    EXPECT_EQ(histogram.count(), expected.count()) << "level " << level;
    EXPECT_EQ(histogram.mean(), expected.mean()) << "level " << level;
    EXPECT_EQ(histogram.max(), expected.max()) << "level " << level;
    EXPECT_TRUE(histogram == expected) << "level " << level;
  }
}

void expect_slowest(const Processor& machine, std::vector<FinishedPixel> pixels) {
  std::stable_sort(pixels.begin(), pixels.end(),
                   [](const FinishedPixel& a, const FinishedPixel& b) { return a.latency > b.latency; });
  const auto slowest = machine.tree_accumulator().slowest().list();
  ASSERT_EQ(slowest.size(), std::min(pixels.size(), SlowestPixels::most));
  for (std::size_t k = 0; k < slowest.size(); ++k) {
    EXPECT_EQ(slowest[k].pixel, pixels[k].pixel) << k;
    EXPECT_EQ(slowest[k].deepest, pixels[k].deepest) << k;
    EXPECT_EQ(slowest[k].latency, pixels[k].latency) << k;
  }
}

TEST(PixelLatency, IsThatBetweenTheDatesOfItsCornerAndItsColour) {
  std::mt19937_64 random(31);
  Simulation simulation;
  std::deque<FinishingOrder> frames;
  for (int k = 0; k < 16; ++k) {
    SimulationOptions options;
    options.max_level = k % 4;
    options.engine = k % 3 == 0 ? Engine::lockstep : Engine::decoupled;
    MachineSpec spec;
    if (k >= 8) spec = random_machine(random, options.max_level);
    if (k < 8) spec.tree_accumulator.latency = 1 + static_cast<Cycle>(k) * 7;
    frames.emplace_back(simulation, column_of_pixels(static_cast<std::uint64_t>(k), 60), spec, options);
  }
  simulation.run();
  int out_of_order = 0;
  for (std::size_t k = 0; k < frames.size(); ++k) {
    SCOPED_TRACE(testing::Message() << "machine " << k);
    const std::vector<FinishedPixel> pixels = frames[k].pixels();
    ASSERT_EQ(pixels.size(), 60U);
    expect_histograms(frames[k].machine(), pixels);
    expect_slowest(frames[k].machine(), pixels);
    out_of_order += frames[k].out_of_order() ? 1 : 0;
  }
  EXPECT_GT(out_of_order, 4) << "pixels with edges are overtaken";
}

/// Of a single pixel on the default machine, worked out by hand in stage_timing_test.cpp: its corner leaves the scan at
/// 3, its colour the accumulator at 19, which takes 2 cycles.
TEST(PixelLatency, OfOnePixelByHand) {
  Simulation simulation;
  const Processor& machine = simulation.add(empty_scene(1, 1, 0.5), {}, {});
  simulation.run();
  ASSERT_EQ(machine.tree_accumulator().slowest().list().size(), 1U);
  EXPECT_EQ(machine.tree_accumulator().slowest().list()[0], (FinishedPixel{0, 0, 19 + 2 - 3}));
  EXPECT_EQ(machine.tree_accumulator().latencies()[0].max(), 18U);
}

}  // namespace
}  // namespace pyrasim::hw
