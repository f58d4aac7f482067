// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "hw_model/processor.h"

namespace pyrasim::cli {

/// Cycles of a frame, simulated in a process of its own: SystemC elaborates once a process. Nothing where the frame is
/// not finished within options.max_cycles. Throws RunError where the process dies.
std::optional<hw::Cycle> simulate_apart(const Scene& scene, const hw::MachineSpec& spec,
                                        const hw::SimulationOptions& options);

}  // namespace pyrasim::cli
