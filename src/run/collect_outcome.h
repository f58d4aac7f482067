// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "hw_model/processor.h"
#include "hw_model/trace/occupancy.h"
#include "run/outcome.h"

namespace pyrasim {

/// All that is known of a processor whose simulation is over. `occupancies`: of its FIFOs, in their order, or none.
Outcome collect_outcome(hw::Processor& processor, const std::vector<std::unique_ptr<hw::Occupancy>>& occupancies);

}  // namespace pyrasim
