// SPDX-License-Identifier: Apache-2.0
// Asking a stage when it can fire decides nothing: whoever asks, whenever and however often, every date stays.
#include <gtest/gtest.h>

#include <deque>
#include <random>

#include "../test_scenes.h"
#include "hw_model/stage/kernel_time.h"
#include "random_machine.h"
#include "simulation.h"
#include "timeline.h"

namespace pyrasim::hw {
namespace {

void ask_all_twice(const Processor& machine) {
  for (const Stage* stage : machine.stages()) {
    const Start first = stage->next_start();
    const Start second = stage->next_start();
    EXPECT_EQ(first.at(), second.at()) << stage->name();
    EXPECT_EQ(first.cause(), second.cause()) << stage->name();
  }
}

/// In every cycle, before and after the stages have done their work in it.
void ask_in_every_cycle(const Processor& machine) {
  while (!machine.complete()) {
    ask_all_twice(machine);
    for (int delta = 0; delta < 3; ++delta) sc_core::wait(sc_core::SC_ZERO_TIME);
    ask_all_twice(machine);
    sc_core::wait(kernel_time(1));
  }
}

TEST(NextStart, DecidesNothing) {
  std::mt19937_64 random(17);
  Simulation simulation;
  struct Machine {
    Processor& processor;
    TimelineRecorder recorder;
    explicit Machine(Processor& its) : processor(its), recorder(its) {}
  };
  std::deque<Machine> left_alone;
  std::deque<Machine> asked;
  int times_asked = 0;
  for (int k = 0; k < 20; ++k) {
    const Scene scene = random_scene(random(), {10, 10, 0}, 12, 8);
    SimulationOptions options;
    options.max_level = static_cast<int>(random() % 5);
    const MachineSpec spec = random_machine(random, options.max_level);
    options.engine = k % 2 == 0 ? Engine::decoupled : Engine::lockstep;
    left_alone.emplace_back(simulation.add(scene, spec, options));
    if (options.engine == Engine::decoupled) {
      options.progress = [&asked, &times_asked, k](double) {
        ask_all_twice(asked[static_cast<std::size_t>(k)].processor);
        ++times_asked;
        return true;
      };
    }
    const Processor& processor = asked.emplace_back(simulation.add(scene, spec, options)).processor;
    if (options.engine == Engine::lockstep) sc_core::sc_spawn([&processor] { ask_in_every_cycle(processor); });
  }
  simulation.run();
  EXPECT_GE(times_asked, 8 * 10);  // after each row, and now and then between
  for (std::size_t k = 0; k < asked.size(); ++k) {
    SCOPED_TRACE("machine " + std::to_string(k));
    EXPECT_EQ(FirstDifference(left_alone[k].recorder.timeline(), asked[k].recorder.timeline()).text(), "");
    expect_same_time(left_alone[k].processor, asked[k].processor);
  }
}

}  // namespace
}  // namespace pyrasim::hw
