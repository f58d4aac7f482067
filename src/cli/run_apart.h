// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstring>
#include <functional>
#include <string>
#include <type_traits>

#include "error.h"

namespace pyrasim::cli {

/// Runs `work` in a process of its own, and returns what it returns. For simulations: SystemC elaborates once a
/// process, and a process that dies takes nothing else along. What `work` throws is thrown here, as an Error of the
/// same exit code. Throws RunError where the process cannot be started or dies, which says how, and Stopped
/// (interrupt.h) where the user interrupts. `what` names the work there, as in "the simulation with intersection.units
/// 256".
std::string run_apart(const std::string& what, const std::function<std::string()>& work);

/// The same for a result of plain memory.
template <class Work>
std::invoke_result_t<Work> run_apart_for(const std::string& what, const Work& work) {
  using Result = std::invoke_result_t<Work>;
  static_assert(std::is_trivially_copyable_v<Result>);
  const std::string bytes = run_apart(what, [&] {
    const Result made = work();
    return std::string(reinterpret_cast<const char*>(&made), sizeof made);
  });
  Result result;
  std::memcpy(&result, bytes.data(), sizeof result);
  return result;
}

/// Throws the Error of `code`; a LimitError where that is its code, which may be of several lines.
[[noreturn]] void throw_error(ExitCode code, const std::string& message);

}  // namespace pyrasim::cli
