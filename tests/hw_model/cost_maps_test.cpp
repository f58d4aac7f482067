// SPDX-License-Identifier: Apache-2.0
// Maps of a machine: cases and rays are the renderer's, latencies those of the accumulator's account.
#include "render/cost_maps.h"

#include <deque>
#include <numeric>

#include "../test_scenes.h"
#include "random_machine.h"
#include "simulation.h"

namespace pyrasim::hw {
namespace {

TEST(CostMapsOfAMachine, AreTheRenderersAndTheAccumulators) {
  std::mt19937_64 random(91);
  Simulation simulation;
  struct Frame {
    const Processor* machine;
    CostMaps *maps, *expected;
  };
  std::deque<CostMaps> maps;
  std::vector<Frame> frames;
  for (int k = 0; k < 8; ++k) {
    Scene scene = random_scene(random(), {12, 12, 1}, 18, 14);
    if (k % 2 == 0) scene.camera.window = PixelWindow{3, 2, 11, 9};
    SimulationOptions options;
    options.max_level = k % 4;
    options.engine = k < 4 ? Engine::decoupled : Engine::lockstep;
    CostMaps& of_machine = maps.emplace_back(scene.camera.rendered(), options.max_level);
    CostMaps& of_renderer = maps.emplace_back(scene.camera.rendered(), options.max_level);
    options.maps = &of_machine;
    frames.push_back(
        {&simulation.add(scene, random_machine(random, options.max_level), options), &of_machine, &of_renderer});
    render_pyramids(scene, SceneIntersector<double>(scene), {.max_level = options.max_level, .maps = &of_renderer});
  }
  simulation.run();
  for (const auto& [machine, of_machine, of_renderer] : frames) {
    EXPECT_EQ(of_machine->rays(), of_renderer->rays());
    EXPECT_EQ(of_machine->picture(CostMap::cases).pixels(), of_renderer->picture(CostMap::cases).pixels());
    const std::vector<std::uint64_t>& latency = of_machine->latency();
    const FinishedPixel& slowest = machine->tree_accumulator().slowest().list().front();
    EXPECT_EQ(*std::max_element(latency.begin(), latency.end()), slowest.latency);
    EXPECT_EQ(latency[slowest.pixel], slowest.latency);
    LatencyHistogram all;
    for (const LatencyHistogram& of_level : machine->tree_accumulator().latencies()) all += of_level;
    EXPECT_EQ(all.count(), latency.size());
    EXPECT_DOUBLE_EQ(std::accumulate(latency.begin(), latency.end(), 0.0),
                     all.mean() * static_cast<double>(all.count()));
  }
}

}  // namespace
}  // namespace pyrasim::hw
