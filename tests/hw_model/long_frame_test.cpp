// SPDX-License-Identifier: Apache-2.0
// Frames that run for very long: in the kernel's time, and for whoever waits for them.
#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "../test_scenes.h"
#include "hw_model/report/deadlock.h"
#include "simulation.h"

namespace pyrasim::hw {
namespace {

SimulationOptions with_engine(Engine engine, int max_level = 2) {
  SimulationOptions options;
  options.max_level = max_level;
  options.engine = engine;
  return options;
}

Scene scene_with_edges() { return random_scene(31, {12, 12, 0}, 10, 8); }

/// 10^9 cycles a corner at 1 kHz: 10^20 ps in all, more than 64 bits count.
TEST(LongFrame, TheClockDoesNotLimitIt) {
  MachineSpec spec;
  spec.clock_mhz = 0.001;
  spec.pixel_scan.interval = 1'000'000'000;
  Simulation simulation;
  const Processor& decoupled = simulation.add(scene_with_edges(), spec, with_engine(Engine::decoupled));
  const Processor& lockstep = simulation.add(scene_with_edges(), spec, with_engine(Engine::lockstep));
  simulation.run();
  EXPECT_GT(decoupled.cycles(), 98'000'000'000U);
  expect_same_time(decoupled, lockstep);
}

/// Half of what a Cycle can count is the limit, whichever engine runs, and the reason says so.
TEST(LongFrame, GivesUpBeforeCyclesOverflow) {
  MachineSpec spec;
  spec.pixel_scan.interval = Cycle{1} << 58U;
  std::vector<std::unique_ptr<Processor>> machines;
  for (const Engine engine : {Engine::decoupled, Engine::lockstep}) {
    machines.push_back(std::make_unique<Processor>(("machine_" + std::to_string(machines.size())).c_str(),
                                                   scene_with_edges(), spec, with_engine(engine)));
  }
  sc_core::sc_start();
  for (const auto& machine : machines) {
    EXPECT_FALSE(machine->complete());
    EXPECT_EQ(machine->max_cycles(), longest_frame);
    const std::string why = why_unfinished(*machine);
    EXPECT_EQ(why.substr(0, why.find('\n')), "the frame is not finished within 9223372036854775808 cycles");
  }
}

/// A pixel's tree alone takes long: nothing is stored meanwhile, and the machine stops all the same.
TEST(LongFrame, AsksWhetherToGoOnInsideOfAPixel) {
  Scene scene = empty_scene(1, 1, 1.0);
  scene.objects.push_back(object(Sphere{{10, 5, 5}, 4}));  // over one corner
  std::vector<std::unique_ptr<Processor>> machines;
  std::array<int, 2> asked{};
  for (const Engine engine : {Engine::decoupled, Engine::lockstep}) {
    SimulationOptions options = with_engine(engine, 12);
    options.progress = [&count = asked[machines.size()]](double share) { return share > 0 || ++count < 3; };
    machines.push_back(std::make_unique<Processor>(("machine_" + std::to_string(machines.size())).c_str(), scene,
                                                   MachineSpec{}, options));
  }
  sc_core::sc_start();
  EXPECT_EQ(asked, (std::array<int, 2>{3, 3}));
  for (const auto& machine : machines) EXPECT_FALSE(machine->complete());
}

}  // namespace
}  // namespace pyrasim::hw
