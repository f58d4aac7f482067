// SPDX-License-Identifier: Apache-2.0
// Machines side by side in one simulation, and what must hold for each and between them.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "hw_model/processor.h"
#include "machines.h"
#include "render/method.h"

namespace pyrasim::hw {

/// Elaborates machines, then runs them all in one simulation; once a process.
class Simulation {
 public:
  Processor& add(const Scene& scene, const MachineSpec& spec, const SimulationOptions& options);
  void run();

 private:
  std::vector<std::unique_ptr<Processor>> machines_;
};

/// What the reference renderer makes of the frame.
Rendering reference(const Scene& scene, const SimulationOptions& simulation);
Rendering reference(const Scene& scene, int max_level);

/// Image and counts of a machine are the reference renderer's.
void expect_results(const Processor& machine, const Rendering& expected);

/// Both machines took the same time for the same reasons: every account is equal.
void expect_same_time(const Processor& a, const Processor& b);

/// What holds for every machine and frame.
void expect_sound(const Processor& machine);

StageStatistics stage_statistics(const Processor& machine, const std::string& stage_name);

}  // namespace pyrasim::hw
