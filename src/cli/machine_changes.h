// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "hw_model/machine_spec.h"

namespace pyrasim::cli {

/// `base` with `changes` of its settings, one after the other: those of --set, "intersection.units=4", and "+N", "-N"
/// or "xN" in place of a number, which is what the setting has now plus, minus or times N (whole again where it has to
/// be). "fifos.all" are all FIFOs, each by its own depth. Throws UsageError.
hw::MachineSpec changed_machine(const hw::MachineSpec& base, const std::vector<std::string>& changes);

}  // namespace pyrasim::cli
