// SPDX-License-Identifier: Apache-2.0
#include "run/child_process.h"

#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <exception>
#include <string_view>
#include <system_error>
#include <utility>

#include "error.h"
#include "run/interrupt.h"

namespace pyrasim {
namespace {

constexpr const char* less_memory = "a smaller --size takes less memory";
constexpr char share_mark = 'p';  ///< begins a share of the work done, where an exit code begins the result
constexpr std::size_t share_size = 1 + sizeof(double);

bool write_all(int end, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(end, bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR) return false;
    if (written > 0) bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

/// Sends the share of the work that is done, a few times a second.
Progress sending_progress(int end) {
  using Clock = std::chrono::steady_clock;
  return [end, last = Clock::time_point()](double share) mutable {
    if (share < 1 && Clock::now() - last < std::chrono::milliseconds(50)) return true;
    last = Clock::now();
    std::array<char, share_size> bytes{share_mark};
    std::memcpy(bytes.data() + 1, &share, sizeof share);
    return write_all(end, {bytes.data(), bytes.size()});
  };
}

/// Sends an exit code, and the result or the error's message.
[[noreturn]] void run_child(int end, const Job& job) {
  std::string message;
  try {
    message = static_cast<char>(exit_ok) + job(sending_progress(end));
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

}  // namespace

ChildProcess::ChildProcess(std::string what, const Job& job) : what_(std::move(what)) {
  int ends[2];
  if (pipe(ends) != 0) throw RunError(fmt::format("{}: {}", what_, why_not_started(errno)));
  const pid_t parent = getpid();
  child_ = fork();
  if (child_ == 0) {
    end_at_signals();
    die_with(parent);
    close(ends[0]);
    run_child(ends[1], job);
  }
  const int fork_error = errno;
  close(ends[1]);
  end_ = ends[0];
  if (child_ > 0) return;
  close(end_);
  throw RunError(fmt::format("{}: {}", what_, why_not_started(fork_error)));
}

ChildProcess::~ChildProcess() {
  if (child_ > 0) {
    kill(child_, SIGKILL);
    wait();
  }
  close(end_);
}

bool ChildProcess::receive() {
  std::array<char, 65536> buffer;
  const ssize_t received = read(end_, buffer.data(), buffer.size());
  if (received < 0) return errno != EINTR;
  received_.append(buffer.data(), static_cast<std::size_t>(received));
  take_shares();
  return received == 0;
}

void ChildProcess::take_shares() {
  std::size_t begin = 0;
  for (; received_.size() - begin >= share_size && received_[begin] == share_mark; begin += share_size) {
    std::memcpy(&share_, received_.data() + begin + 1, sizeof share_);
  }
  received_.erase(0, begin);
}

int ChildProcess::wait() {
  int status = 0;
  while (waitpid(child_, &status, 0) < 0 && errno == EINTR) {
  }
  child_ = 0;
  return status;
}

std::string ChildProcess::result() {
  const int status = wait();
  if (status != 0 || received_.empty()) throw RunError(fmt::format("{} {}", what_, how_it_died(status)));
  const auto code = static_cast<ExitCode>(received_.front());
  received_.erase(0, 1);
  if (code == exit_run_failed) throw RunError(fmt::format("{}: {}", what_, received_));
  if (code != exit_ok) throw_error(code, received_);
  return std::move(received_);
}

}  // namespace pyrasim
