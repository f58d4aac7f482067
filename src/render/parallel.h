// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <atomic>
#include <functional>
#include <mutex>
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
/// been are finished, because others may wait for them.
template <class Worker, class Context>
void run_tasks(int tasks, int threads, const Progress& progress, Context& context) {
  std::atomic<int> next{0};
  std::mutex report;
  int finished = 0;
  const auto loop = [&] {
    Worker worker(context);
    for (int task = next++; task < tasks; task = next++) {
      worker(task);
      if (!progress) continue;
      const std::scoped_lock lock(report);
      if (!progress(static_cast<double>(++finished) / tasks)) next = tasks;
    }
  };
  std::vector<std::jthread> helpers;
  for (int k = 1; k < std::min(threads, tasks); ++k) helpers.emplace_back(loop);
  loop();
}

}  // namespace pyrasim
