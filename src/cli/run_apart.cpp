// SPDX-License-Identifier: Apache-2.0
#include "cli/run_apart.h"

#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <exception>
#include <optional>
#include <string_view>
#include <system_error>

#include "cli/interrupt.h"

namespace pyrasim::cli {
namespace {

constexpr int heartbeat = 100;  ///< ms after which a signal that came between two system calls is seen
constexpr const char* less_memory = "a smaller --size takes less memory";

bool write_all(int end, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(end, bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR) return false;
    if (written > 0) bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

/// What comes until the writer closes its end; none where the user interrupts before.
std::optional<std::string> read_all(int end) {
  std::string bytes;
  std::array<char, 4096> buffer;
  for (;;) {
    if (interrupted()) return std::nullopt;
    pollfd ready{end, POLLIN, 0};
    if (poll(&ready, 1, heartbeat) <= 0) continue;
    const ssize_t received = read(end, buffer.data(), buffer.size());
    if (received > 0) {
      bytes.append(buffer.data(), static_cast<std::size_t>(received));
    } else if (received == 0 || errno != EINTR) {
      return bytes;
    }
  }
}

/// Sends an exit code, and the result or the error's message.
[[noreturn]] void run_child(int end, const std::function<std::string()>& work) {
  std::string message;
  try {
    message = static_cast<char>(exit_ok) + work();
  } catch (const Error& error) {
    message = static_cast<char>(error.exit_code()) + std::string(error.what());
  } catch (const std::bad_alloc&) {
    message = static_cast<char>(exit_run_failed) + fmt::format("out of memory; {}", less_memory);
  } catch (const std::exception& error) {
    message = static_cast<char>(exit_run_failed) + std::string(error.what());
  }
  _exit(write_all(end, message) ? exit_ok : exit_run_failed);
}

/// A killed parent takes this process with it.
void die_with(pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(exit_run_failed);  // it was killed before
}

std::string why_not_started(int error_number) {
  const std::string reason = std::generic_category().message(error_number);
  const char* advice = error_number == EAGAIN ? "; the user's limit on processes (ulimit -u) may be reached" : "";
  if (error_number == ENOMEM) return fmt::format("cannot start a process: {}; {}", reason, less_memory);
  return fmt::format("cannot start a process: {}{}", reason, advice);
}

std::string how_it_died(int status) {
  if (WIFEXITED(status)) return fmt::format("ended with exit code {} and without a result", WEXITSTATUS(status));
  const int number = WTERMSIG(status);
  const char* name = sigabbrev_np(number);
  const std::string signal = name != nullptr ? fmt::format("SIG{}", name) : fmt::format("signal {}", number);
  if (number == SIGKILL) {
    return fmt::format("was killed by {}, as the system does where memory runs out; {}", signal, less_memory);
  }
  return fmt::format("was ended by {}", signal);
}

int wait_for(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

}  // namespace

std::string run_apart(const std::string& what, const std::function<std::string()>& work) {
  stop_if_interrupted();
  int ends[2];
  if (pipe(ends) != 0) throw RunError(fmt::format("{}: {}", what, why_not_started(errno)));
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child == 0) {
    end_at_signals();
    die_with(parent);
    close(ends[0]);
    run_child(ends[1], work);
  }
  const int fork_error = errno;
  close(ends[1]);
  const std::optional<std::string> message = child > 0 ? read_all(ends[0]) : std::nullopt;
  close(ends[0]);
  if (child < 0) throw RunError(fmt::format("{}: {}", what, why_not_started(fork_error)));
  if (!message) kill(child, SIGKILL);
  const int status = wait_for(child);
  stop_if_interrupted();
  if (status != 0 || !message || message->empty()) throw RunError(fmt::format("{} {}", what, how_it_died(status)));
  const auto code = static_cast<ExitCode>(message->front());
  if (code == exit_run_failed) throw RunError(fmt::format("{}: {}", what, message->substr(1)));
  if (code != exit_ok) throw_error(code, message->substr(1));
  return message->substr(1);
}

void throw_error(ExitCode code, const std::string& message) {
  if (code == exit_limit) throw LimitError(message);
  throw Error(code, message);
}

}  // namespace pyrasim::cli
