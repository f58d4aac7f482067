// SPDX-License-Identifier: Apache-2.0
#include "run/run_simulation.h"

#include <fmt/format.h>

#include <new>
#include <string>
#include <string_view>
#include <systemc>

#if defined(__SANITIZE_ADDRESS__)
#include <pthread.h>
#include <sanitizer/common_interface_defs.h>
#endif

#include "error.h"

namespace pyrasim {
namespace {

/// SystemC tells AddressSanitizer which stack it changes to, but for the one that sc_start() was called on: without
/// this, what is thrown later clears the wrong stack of marks, and good code is reported.
void announce_own_stack() {
#if defined(__SANITIZE_ADDRESS__)
  pthread_attr_t attributes;
  if (pthread_getattr_np(pthread_self(), &attributes) != 0) return;
  void* bottom = nullptr;
  std::size_t size = 0;
  pthread_attr_getstack(&attributes, &bottom, &size);
  pthread_attr_destroy(&attributes);
  __sanitizer_start_switch_fiber(nullptr, bottom, size);
  __sanitizer_finish_switch_fiber(nullptr, nullptr, nullptr);
#endif
}

}  // namespace

void run_simulation() {
  try {
    sc_core::sc_start();
    announce_own_stack();
  } catch (const sc_core::sc_report& report) {
    announce_own_stack();
    const std::string_view kind = report.get_msg_type();
    const std::string_view message = report.get_msg();
    if (message == std::bad_alloc().what() || kind == sc_core::SC_ID_STACK_SETUP_FAILED_) throw std::bad_alloc();
    if (kind == sc_core::SC_ID_SIMULATION_UNCAUGHT_EXCEPTION_) throw RunError(std::string(message));
    throw RunError(fmt::format("the simulation: {}: {}", kind, message));
  }
}

}  // namespace pyrasim
