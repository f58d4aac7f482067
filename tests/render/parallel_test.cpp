// SPDX-License-Identifier: Apache-2.0
#include "render/parallel.h"

#include <gtest/gtest.h>

#include <vector>

namespace pyrasim {
namespace {

struct Tally {
  std::vector<std::atomic<int>> runs;
  std::atomic<int> workers{0};
};

class TallyWorker {
 public:
  explicit TallyWorker(Tally& tally) : tally_(tally) { ++tally.workers; }
  void operator()(int task) { ++tally_.runs.at(static_cast<std::size_t>(task)); }

 private:
  Tally& tally_;
};

TEST(ParallelTasks, AreEachRunOnceWhateverTheThreads) {
  for (const int tasks : {0, 1, 2, 1000}) {
    for (const int threads : {1, 2, 8}) {
      Tally tally{std::vector<std::atomic<int>>(static_cast<std::size_t>(tasks)), {}};
      std::vector<double> shares;  // of one thread at a time: nothing else guards it
      run_tasks<TallyWorker>(
          tasks, threads,
          [&](double share) {
            shares.push_back(share);
            return true;
          },
          tally);
      for (const auto& runs : tally.runs) EXPECT_EQ(runs, 1) << tasks << " tasks, " << threads << " threads";
      EXPECT_EQ(tally.workers, std::max(1, std::min(tasks, threads)));
      ASSERT_EQ(shares.size(), static_cast<std::size_t>(tasks));
      for (std::size_t k = 0; k < shares.size(); ++k) EXPECT_EQ(shares[k], static_cast<double>(k + 1) / tasks);
    }
  }
}

/// What has been started when progress says to stop is finished, one task a thread at most; nothing else is started.
TEST(ParallelTasks, NoneIsStartedAfterTheStop) {
  constexpr int threads = 4;
  Tally tally{std::vector<std::atomic<int>>(10'000), {}};
  int reports = 0;
  run_tasks<TallyWorker>(
      10'000, threads, [&](double) { return ++reports < 10; }, tally);
  EXPECT_GE(reports, 10);
  EXPECT_LE(reports, 10 + threads - 1);
  int runs = 0;
  for (const auto& of_task : tally.runs) runs += of_task;
  EXPECT_EQ(runs, reports);
}

}  // namespace
}  // namespace pyrasim
