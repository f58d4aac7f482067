// SPDX-License-Identifier: Apache-2.0
#include "cli/simulate_apart.h"

#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <exception>
#include <system_error>

#include "error.h"

namespace pyrasim::cli {
namespace {

[[noreturn]] void run_child(int result, const Scene& scene, const hw::MachineSpec& spec,
                            const hw::SimulationOptions& options) {
  bool written = false;
  try {
    hw::Processor processor("processor", scene, spec, options);
    sc_core::sc_start();
    const bool finished = processor.complete() && processor.cycles() <= options.max_cycles;
    const hw::Cycle cycles = finished ? processor.cycles() : hw::never;
    written = write(result, &cycles, sizeof cycles) == static_cast<ssize_t>(sizeof cycles);
  } catch (const std::exception&) {  // the parent sees that there is no result
  }
  _exit(written ? exit_ok : exit_run_failed);
}

}  // namespace

std::optional<hw::Cycle> simulate_apart(const Scene& scene, const hw::MachineSpec& spec,
                                        const hw::SimulationOptions& options) {
  int ends[2];
  if (pipe(ends) != 0) throw RunError("pipe: " + std::system_category().message(errno));
  const pid_t child = fork();
  if (child == 0) run_child(ends[1], scene, spec, options);
  close(ends[1]);
  hw::Cycle cycles = hw::never;
  const bool received = child > 0 && read(ends[0], &cycles, sizeof cycles) == static_cast<ssize_t>(sizeof cycles);
  close(ends[0]);
  if (child < 0) throw RunError("fork: " + std::system_category().message(errno));
  waitpid(child, nullptr, 0);
  if (!received) throw RunError("a simulation died");
  return cycles == hw::never ? std::nullopt : std::optional(cycles);
}

}  // namespace pyrasim::cli
