// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <atomic>
#include <exception>
#include <functional>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace pyrasim {

/// Called with the finished share of a job, 0 to 1; never from two threads at once. Says whether to go on with the job.
/// May be empty.
using Progress = std::function<bool(double)>;

/// The number of threads meant by `requested`: itself, or one for each core where it is 0.
inline int thread_count(int requested) {
  return requested > 0 ? requested : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

/// Runs the tasks 0 to `tasks` - 1, each once, started in ascending order, on `threads` threads: each has a
/// Worker(context) and calls worker(task). Where `progress` says to stop, no further task is started; those that have
/// been are finished, because others may wait for them. Where the system has no room for a thread, those that there are
/// do the work. Throws what a worker throws first, when all threads have ended; one that waits for another's task has
/// to be told by that task.
template <class Worker, class Context>
void run_tasks(int tasks, int threads, const Progress& progress, Context& context) {
  std::atomic<int> next{0};
  std::mutex report;
  int finished = 0;
  std::exception_ptr failure;
  const auto run = [&] {
    Worker worker(context);
    for (int task = next++; task < tasks; task = next++) {
      worker(task);
      if (!progress) continue;
      const std::scoped_lock lock(report);
      if (!progress(static_cast<double>(++finished) / tasks)) next = tasks;
    }
  };
  const auto loop = [&] {
    try {
      run();
    } catch (...) {
      const std::scoped_lock lock(report);
      if (!failure) failure = std::current_exception();
      next = tasks;
    }
  };
  std::vector<std::jthread> helpers;
  try {
    for (int k = 1; k < std::min(threads, tasks); ++k) helpers.emplace_back(loop);
  } catch (const std::system_error&) {  // no thread to be had
  }
  loop();
  helpers.clear();  // waits for them
  if (failure) std::rethrow_exception(failure);
}

}  // namespace pyrasim
