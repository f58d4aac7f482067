// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hw_model/processor.h"
#include "hw_model/report/critical_path.h"
#include "hw_model/trace/occupancies.h"
#include "run/outcome.h"

namespace pyrasim {

/// All that is known of a processor whose simulation is over. Occupancies of its FIFOs and the
/// critical path of its frame, not finished yet, where somebody has watched them; else null.
Outcome collect_outcome(hw::Processor& processor, hw::Occupancies* occupancies, hw::CriticalPath* critical_path);

}  // namespace pyrasim
