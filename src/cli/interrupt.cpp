// SPDX-License-Identifier: Apache-2.0
#include "cli/interrupt.h"

#include <atomic>
#include <csignal>

#include "error.h"

namespace pyrasim::cli {
namespace {

std::atomic<int> last_signal = 0;  ///< the only thing that a signal handler can reach
static_assert(std::atomic<int>::is_always_lock_free);

using Handler = void (*)(int);

/// What is ignored stays so, as for a shell's background jobs.
void handle(Handler handler) {
  for (const int number : {SIGINT, SIGTERM}) {
    if (std::signal(number, handler) == SIG_IGN) std::signal(number, SIG_IGN);
  }
}

extern "C" void note_signal(int number) {
  last_signal = number;
  handle(SIG_DFL);
}

}  // namespace

void run_interruptibly(const std::function<void()>& job, const std::function<std::string()>& how_far) {
  handle(note_signal);
  job();
  handle(SIG_DFL);
  if (interrupted()) throw Interrupted(last_signal, how_far());
}

bool interrupted() { return last_signal != 0; }

}  // namespace pyrasim::cli
