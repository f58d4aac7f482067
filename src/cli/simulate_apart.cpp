// SPDX-License-Identifier: Apache-2.0
#include "cli/simulate_apart.h"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <exception>
#include <system_error>

#include "error.h"
#include "hw_model/report/deadlock.h"

namespace pyrasim::cli {
namespace {

bool write_all(int end, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(end, bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR) return false;
    if (written > 0) bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

std::string read_all(int end) {
  std::string bytes;
  std::array<char, 4096> buffer;
  for (;;) {
    const ssize_t received = read(end, buffer.data(), buffer.size());
    if (received > 0) {
      bytes.append(buffer.data(), static_cast<std::size_t>(received));
    } else if (received == 0 || errno != EINTR) {
      return bytes;
    }
  }
}

/// Sends the frame's cycles, and then why it is not finished, if so.
[[noreturn]] void run_child(int result, const Scene& scene, const hw::MachineSpec& spec,
                            const hw::SimulationOptions& options) {
  bool written = false;
  try {
    hw::Processor processor("processor", scene, spec, options);
    sc_core::sc_start();
    const hw::Cycle cycles = processor.cycles();
    std::string bytes(sizeof cycles, 0);
    std::memcpy(bytes.data(), &cycles, sizeof cycles);
    written = write_all(result, bytes + hw::why_unfinished(processor));
  } catch (const std::exception&) {  // the parent sees that there is no result
  }
  _exit(written ? exit_ok : exit_run_failed);
}

/// A killed parent takes this process with it.
void die_with(pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(exit_run_failed);  // it was killed before
}

}  // namespace

ApartResult simulate_apart(const Scene& scene, const hw::MachineSpec& spec, const hw::SimulationOptions& options) {
  int ends[2];
  if (pipe(ends) != 0) throw RunError("pipe: " + std::system_category().message(errno));
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child == 0) die_with(parent);
  if (child == 0) run_child(ends[1], scene, spec, options);
  const int fork_error = errno;
  close(ends[1]);
  const std::string bytes = child > 0 ? read_all(ends[0]) : "";
  close(ends[0]);
  if (child < 0) throw RunError("fork: " + std::system_category().message(fork_error));
  int status = 0;
  waitpid(child, &status, 0);
  hw::Cycle cycles = 0;
  if (status != 0 || bytes.size() < sizeof cycles) throw RunError("a simulation died");
  std::memcpy(&cycles, bytes.data(), sizeof cycles);
  const std::string why = bytes.substr(sizeof cycles);
  return {why.empty() ? std::optional(cycles) : std::nullopt, why};
}

}  // namespace pyrasim::cli
