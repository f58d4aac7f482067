// SPDX-License-Identifier: Apache-2.0
#include "run/interrupt.h"

#include <poll.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <string_view>

#include "error.h"

namespace pyrasim {
namespace {

constexpr unsigned patience = 1;  ///< seconds that a job has to end by itself

std::atomic<int> last_signal = 0;  ///< the only thing that a signal handler can reach
static_assert(std::atomic<int>::is_always_lock_free);

using Handler = void (*)(int);

/// What is ignored stays so, as for a shell's background jobs.
void handle(Handler handler) {
  for (const int number : {SIGINT, SIGTERM}) {
    if (std::signal(number, handler) == SIG_IGN) std::signal(number, SIG_IGN);
  }
}

/// The job does not end: it computes for long, or waits for a reader or a writer. It says so only where that cannot
/// wait as well.
extern "C" void end_now(int /*alarm*/) {
  constexpr std::string_view line = "pyrasim: interrupted\n";
  pollfd end{STDERR_FILENO, POLLOUT, 0};
  if (poll(&end, 1, 0) == 1) [[maybe_unused]]
    const ssize_t ignored = write(STDERR_FILENO, line.data(), line.size());
  _exit(exit_signal + last_signal);
}

extern "C" void note_signal(int number) {
  last_signal = number;
  handle(SIG_DFL);
  alarm(patience);
}

/// Arms the alarm, which whoever started this program may have blocked.
void expect_alarm() {
  std::signal(SIGALRM, end_now);
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGALRM);
  pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
}

}  // namespace

void run_interruptibly(const std::function<void()>& job, const std::function<std::string()>& how_far) {
  expect_alarm();
  handle(note_signal);
  try {
    job();
  } catch (const Stopped&) {  // told below
  }
  handle(SIG_DFL);
  if (interrupted()) throw Interrupted(last_signal, how_far());
}

bool interrupted() { return last_signal != 0; }

void stop_if_interrupted() {
  if (interrupted()) throw Stopped{};
}

void end_at_signals() { handle(SIG_DFL); }

}  // namespace pyrasim
