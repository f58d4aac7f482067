// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "hw_model/machine_spec.h"

namespace pyrasim::hw {

/// One unit, all latencies and intervals 1, and every ray takes the unit one cycle.
MachineSpec quick_machine();

MachineSpec with_all_fifos(MachineSpec spec, std::size_t depth);

}  // namespace pyrasim::hw
