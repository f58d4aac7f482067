// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hw_model/processor.h"
#include "hw_model/trace/occupancies.h"
#include "run/outcome.h"

namespace pyrasim {

/// All that is known of a processor whose simulation is over. `occupancies`: of its FIFOs, or null.
Outcome collect_outcome(hw::Processor& processor, hw::Occupancies* occupancies);

}  // namespace pyrasim
