// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <systemc>

#include "hw_model/cycle.h"

namespace pyrasim::hw {

/// `cycles` as the SystemC kernel counts time: one unit of its resolution each, whatever the clock, which only turns
/// cycles into seconds. In picoseconds, a frame at 1 kHz would pass the kernel's 64 bits after 1.8e10 cycles.
inline sc_core::sc_time kernel_time(Cycle cycles) { return sc_core::sc_time::from_value(cycles); }

}  // namespace pyrasim::hw
