// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace pyrasim {

/// Runs SystemC's kernel until the frame ends. What a process of the simulation threw, of which SystemC leaves only the
/// text, is thrown as std::bad_alloc where memory ran out, else as RunError.
void run_simulation();

}  // namespace pyrasim
