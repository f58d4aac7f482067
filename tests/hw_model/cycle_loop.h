// SPDX-License-Identifier: Apache-2.0
// The machine of docs/machine.md once more, as a plain loop over cycles: no SystemC, no dates worked out ahead. Slow
// and simple; the Processor is checked against it.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "hw_model/machine_spec.h"
#include "intersect/datapath_formats.h"
#include "scene/scene.h"

namespace pyrasim::hw {

/// When the tokens of a FIFO were written and read, in order. Tokens that lie in it at cycle 0 have no write.
struct FifoDates {
  std::vector<Cycle> writes;
  std::vector<Cycle> reads;
  friend bool operator==(const FifoDates&, const FifoDates&) = default;
};

/// All that a machine did in a frame, as far as time goes.
struct Timeline {
  Cycle cycles = 0;
  std::map<std::string, FifoDates> fifos;  ///< those that were built, by their names in the machine
};

/// One frame on one machine, which must hold the frame's trees. Throws std::logic_error where it stands still.
Timeline run_cycle_loop(const Scene& scene, const MachineSpec& spec, int max_level,
                        const DatapathFormats& formats = {});

}  // namespace pyrasim::hw
