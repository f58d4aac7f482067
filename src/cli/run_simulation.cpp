// SPDX-License-Identifier: Apache-2.0
#include "cli/run_simulation.h"

#include <fmt/format.h>

#include <new>
#include <string_view>
#include <systemc>

#include "error.h"

namespace pyrasim::cli {

void run_simulation() {
  try {
    sc_core::sc_start();
  } catch (const sc_core::sc_report& report) {
    const std::string_view kind = report.get_msg_type();
    const std::string_view message = report.get_msg();
    if (message == std::bad_alloc().what() || kind == sc_core::SC_ID_STACK_SETUP_FAILED_) throw std::bad_alloc();
    throw RunError(fmt::format("the simulation: {}: {}", kind, message));
  }
}

}  // namespace pyrasim::cli
