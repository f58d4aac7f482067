// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "hw_model/processor.h"

namespace pyrasim::cli {

/// What became of a frame.
struct ApartResult {
  std::optional<hw::Cycle> cycles;  ///< none where the frame is not finished within options.max_cycles
  std::string why_unfinished;       ///< as in report/deadlock.h
};

/// Simulates a frame in a process of its own: SystemC elaborates once a process. Throws RunError where that dies.
ApartResult simulate_apart(const Scene& scene, const hw::MachineSpec& spec, const hw::SimulationOptions& options);

}  // namespace pyrasim::cli
