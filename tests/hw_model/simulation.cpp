// SPDX-License-Identifier: Apache-2.0
#include "simulation.h"

#include <algorithm>
#include <map>

#include "hw_model/report/deadlock.h"

namespace pyrasim::hw {

Processor& Simulation::add(const Scene& scene, const MachineSpec& spec, const SimulationOptions& options) {
  machines_.push_back(
      std::make_unique<Processor>(("machine_" + std::to_string(machines_.size())).c_str(), scene, spec, options));
  return *machines_.back();
}

void Simulation::run() {
  sc_core::sc_start();
  for (const auto& machine : machines_) ASSERT_TRUE(machine->complete()) << machine_state(*machine);
}

Rendering reference(const Scene& scene, const SimulationOptions& simulation) {
  Method method;
  method.pyramids = {.max_level = simulation.max_level, .edge = simulation.edge};
  return render(scene, method, simulation.formats, 1);
}

Rendering reference(const Scene& scene, int max_level) {
  SimulationOptions simulation;
  simulation.max_level = max_level;
  return reference(scene, simulation);
}

void expect_results(const Processor& machine, const Rendering& expected) {
  EXPECT_TRUE(machine.image().pixels() == expected.image.pixels()) << machine.name();
  const FrameStatistics statistics = machine.statistics();
  EXPECT_EQ(statistics.rays_by_level, expected.statistics.rays_by_level) << machine.name();
  EXPECT_EQ(statistics.cases_by_level, expected.statistics.cases_by_level) << machine.name();
  EXPECT_EQ(statistics.subdivisions, expected.statistics.subdivisions) << machine.name();
  EXPECT_EQ(statistics.terminal_nodes, expected.statistics.terminal_nodes) << machine.name();
  EXPECT_EQ(statistics.work, expected.statistics.work) << machine.name();
}

void expect_same_time(const Processor& a, const Processor& b) {
  EXPECT_EQ(a.cycles(), b.cycles()) << a.name();
  ASSERT_EQ(a.stages().size(), b.stages().size());
  for (std::size_t k = 0; k < a.stages().size(); ++k) {
    const StageStatistics x = a.stages()[k]->statistics(a.cycles());
    const StageStatistics y = b.stages()[k]->statistics(b.cycles());
    const char* name = a.stages()[k]->name();
    EXPECT_EQ(x.busy, y.busy) << name;
    EXPECT_EQ(x.starved, y.starved) << name;
    EXPECT_EQ(x.blocked, y.blocked) << name;
    EXPECT_EQ(x.idle, y.idle) << name;
    EXPECT_EQ(x.firings, y.firings) << name;
  }
  const auto slowest = [](const Processor& machine) { return machine.tree_accumulator().slowest().list(); };
  EXPECT_TRUE(std::equal(slowest(a).begin(), slowest(a).end(), slowest(b).begin(), slowest(b).end())) << a.name();
  ASSERT_EQ(a.fifos().size(), b.fifos().size());
  for (std::size_t k = 0; k < a.fifos().size(); ++k) {
    const FifoStatistics& x = a.fifos()[k]->statistics();
    const FifoStatistics& y = b.fifos()[k]->statistics();
    const char* name = a.fifos()[k]->name();
    EXPECT_EQ(x.max, y.max) << name;
    EXPECT_EQ(x.token_cycles, y.token_cycles) << name;
    EXPECT_EQ(x.tokens, y.tokens) << name;
    EXPECT_EQ(x.starved, y.starved) << name;
    EXPECT_EQ(x.blocked, y.blocked) << name;
  }
}

void expect_sound(const Processor& machine) {
  const Cycle cycles = machine.cycles();
  std::map<std::string, Cycle> waits;
  for (const Stage* stage : machine.stages()) {
    const StageStatistics s = stage->statistics(cycles);
    EXPECT_EQ(s.busy + s.starved + s.blocked + s.idle, cycles) << stage->name();
    EXPECT_LE(s.busy, cycles) << stage->name();
    EXPECT_LE(s.firings, s.busy) << stage->name();
    waits["starved"] += s.starved;
    waits["blocked"] += s.blocked;
  }
  std::map<std::string, Cycle> causes;
  for (const FifoBase* fifo : machine.fifos()) {
    const FifoStatistics& s = fifo->statistics();
    EXPECT_LE(s.max, s.depth) << fifo->name();
    EXPECT_LE(s.token_cycles, s.depth * (cycles + 1)) << fifo->name();
    causes["starved"] += s.starved;
    causes["blocked"] += s.blocked;
    const bool credits = std::string(fifo->basename()) == "tree_accumulator_to_pixel_scan";
    EXPECT_TRUE(credits || fifo->empty()) << fifo->name();
  }
  EXPECT_EQ(waits, causes) << machine.name();
  if (machine.controller() != nullptr) {
    EXPECT_LE(machine.controller()->pool_max(), machine.controller()->pool_depth()) << machine.name();
  }
}

StageStatistics stage_statistics(const Processor& machine, const std::string& stage_name) {
  for (const Stage* stage : machine.stages()) {
    if (stage->basename() == stage_name) return stage->statistics(machine.cycles());
  }
  ADD_FAILURE() << stage_name << " was not built";
  return {};
}

}  // namespace pyrasim::hw
