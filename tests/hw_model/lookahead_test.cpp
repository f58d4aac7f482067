// SPDX-License-Identifier: Apache-2.0
// The decoupled engine lets the generator run ahead of all that its own rays can bring back. Machines whose loop is as
// short as can be, with one cell for parents, so that the read of a parent is what the controller waits for: there a
// request comes back in the very cycle in which the generator may choose again.
#include <gtest/gtest.h>

#include <deque>

#include "../test_scenes.h"
#include "cycle_loop.h"
#include "simulation.h"
#include "timeline.h"

namespace pyrasim::hw {
namespace {

/// Latencies of generator, units and controller from 1 to 4.
std::vector<MachineSpec> short_loops() {
  std::vector<MachineSpec> machines;
  for (const Cycle generator : {1, 2, 3, 4}) {
    for (const Cycle unit : {1, 2, 3, 4}) {
      for (const Cycle controller : {1, 2, 3, 4}) {
        MachineSpec spec = quick_machine();
        spec.view_vector_generator.latency = generator;
        spec.intersection_latency = unit;
        spec.subdivision_controller.latency = controller;
        spec.fifos.subdivision_controller_to_pyramid_classifier = 1;
        machines.push_back(spec);
      }
    }
  }
  return machines;
}

TEST(DecoupledEngine, SeesARequestInTheCycleInWhichItsOwnRaysBringItBack) {
  const Scene scene = random_scene(21, {12, 12, 0}, 12, 9);
  SimulationOptions options;
  options.max_level = 3;
  Simulation simulation;
  std::deque<TimelineRecorder> recorders;
  const std::vector<MachineSpec> machines = short_loops();
  for (const MachineSpec& spec : machines) recorders.emplace_back(simulation.add(scene, spec, options));
  simulation.run();
  for (std::size_t k = 0; k < machines.size(); ++k) {
    const Timeline loop = run_cycle_loop(scene, machines[k], options.max_level);
    EXPECT_EQ(FirstDifference(loop, recorders[k].timeline()).text(), "")
        << "latencies " << machines[k].view_vector_generator.latency << ", " << machines[k].intersection_latency << ", "
        << machines[k].subdivision_controller.latency;
  }
}

}  // namespace
}  // namespace pyrasim::hw
