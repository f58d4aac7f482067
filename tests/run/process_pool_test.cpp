// SPDX-License-Identifier: Apache-2.0
#include "run/process_pool.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <thread>
#include <vector>

#include "../error_of.h"
#include "error.h"

namespace pyrasim {
namespace {

using namespace std::chrono_literals;

/// Neither running nor waited for.
void expect_no_process_left() {
  EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1);
  EXPECT_EQ(errno, ECHILD);
}

/// What is taken of `size` jobs, and the message of the Error that ends them.
struct Taken {
  std::vector<std::string> results;
  std::string error;
  friend bool operator==(const Taken&, const Taken&) = default;
};

Taken take_all(std::size_t size, const std::function<Job(std::size_t)>& prepare, int at_once) {
  Taken taken;
  JobList list{.size = size, .what = "a job", .prepare = prepare};
  list.take = [&](std::size_t k, const std::string& result) {
    EXPECT_EQ(k, taken.results.size());
    taken.results.push_back(result);
  };
  try {
    ProcessPool::run(list, at_once);
  } catch (const Error& error) {
    taken.error = error.what();
  }
  expect_no_process_left();
  return taken;
}

TEST(ProcessPool, TakesResultsInOrder) {
  const auto later_ones_first = [](std::size_t k) {
    return [k](const Progress&) {
      std::this_thread::sleep_for((8 - k) * 10ms);
      return std::string(100'000, static_cast<char>('a' + k));  // more than a pipe holds
    };
  };
  for (const int at_once : {1, 3, 20}) {
    const Taken taken = take_all(8, later_ones_first, at_once);
    ASSERT_EQ(taken.results.size(), 8U);
    for (std::size_t k = 0; k < 8; ++k) EXPECT_EQ(taken.results[k], std::string(100'000, static_cast<char>('a' + k)));
  }
}

TEST(ProcessPool, RunsSoManyAtTheSameTime) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  const auto prepare = [&](std::size_t k) {
    return [&ends, k](const Progress&) {
      char byte = 'x';
      const ssize_t moved =
          k == 0 ? read(ends[0], &byte, 1) : write(ends[1], &byte, 1);  // the first waits for the other
      return std::to_string(moved);
    };
  };
  EXPECT_EQ(take_all(2, prepare, 2).results, (std::vector<std::string>{"1", "1"}));
}

TEST(ProcessPool, NeverRunsMore) {
  int running = 0;
  int most = 0;
  JobList list{.size = 9, .what = "a job"};
  list.prepare = [&](std::size_t) {
    most = std::max(most, ++running);  // at least those that run: one that has ended may not be taken yet
    return [](const Progress&) { return std::string("done"); };
  };
  list.take = [&](std::size_t, const std::string&) { --running; };
  ProcessPool::run(list, 1);
  EXPECT_EQ(most, 1);
}

TEST(ProcessPool, TheFirstFailureInOrderCounts) {
  const auto prepare = [](std::size_t k) -> Job {
    if (k == 6) throw InputError("prepared badly");
    return [k](const Progress&) -> std::string {
      if (k == 3) {
        std::this_thread::sleep_for(100ms);
        throw LimitError("too long\nfor two lines");
      }
      if (k == 4) throw UsageError("later, but sooner");
      std::this_thread::sleep_for(k == 2 ? 200ms : 1ms);
      return std::to_string(k);
    };
  };
  const Taken alone = take_all(9, prepare, 1);
  EXPECT_EQ(alone, (Taken{{"0", "1", "2"}, "too long\nfor two lines"}));
  for (const int at_once : {2, 4, 9}) EXPECT_EQ(take_all(9, prepare, at_once), alone);
}

TEST(ProcessPool, NothingIsStartedBehindAFailure) {
  std::size_t prepared = 0;
  const auto prepare = [&](std::size_t k) {
    ++prepared;
    return [k](const Progress&) -> std::string {
      if (k == 1) throw UsageError("no");
      std::this_thread::sleep_for(k == 0 ? 300ms : 1ms);  // the failure is known long before the first result
      return "yes";
    };
  };
  EXPECT_EQ(take_all(50, prepare, 2), (Taken{{"yes"}, "no"}));
  EXPECT_EQ(prepared, 2U);
}

TEST(ProcessPool, ErrorsKeepTheirKind) {
  const auto code_of = [](const Job& job) {
    try {
      ProcessPool::run({.size = 1, .what = "a job", .prepare = [&](std::size_t) { return job; }}, 1);
    } catch (const Error& error) {
      return static_cast<int>(error.exit_code());
    }
    return 0;
  };
  EXPECT_EQ(code_of([](const Progress&) -> std::string { throw LimitError("x"); }), exit_limit);
  EXPECT_EQ(code_of([](const Progress&) -> std::string { throw InputError("x"); }), exit_input);
  EXPECT_EQ(code_of([](const Progress&) -> std::string { throw std::runtime_error("x"); }), exit_run_failed);
  EXPECT_EQ(code_of([](const Progress&) -> std::string { throw std::bad_alloc(); }), exit_run_failed);
}

TEST(ProcessPool, SaysHowAProcessDied) {
  const auto error_with = [](const Job& job) {
    return take_all(
               1, [&](std::size_t) { return job; }, 1)
        .error;
  };
  EXPECT_EQ(error_with([](const Progress&) -> std::string { _exit(7); }),
            "a job ended with exit code 7 and without a result");
  EXPECT_EQ(error_with([](const Progress&) -> std::string {
              raise(SIGTERM);
              return "";
            }),
            "a job was ended by SIGTERM");
  EXPECT_EQ(error_with([](const Progress&) -> std::string { throw std::bad_alloc(); }),
            "a job: out of memory; a smaller --size takes less memory");
}

TEST(ProcessPool, NothingToDoIsAnEmptyResult) {
  const auto every_other = [](std::size_t k) {
    return k % 2 == 0 ? Job() : [k](const Progress&) { return std::to_string(k); };
  };
  for (const int at_once : {1, 2}) {
    EXPECT_EQ(take_all(5, every_other, at_once).results, (std::vector<std::string>{"", "1", "", "3", ""}));
  }
}

TEST(ProcessPool, WhatTakesAResultMayFail) {
  JobList list{.size = 5, .what = "a job"};
  list.prepare = [](std::size_t k) {
    return [k](const Progress&) {
      if (k > 1) std::this_thread::sleep_for(10s);
      return std::string();
    };
  };
  list.take = [](std::size_t k, const std::string&) {
    if (k == 1) throw RunError("the disk is full");
  };
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ(error_of<RunError>([&] { ProcessPool::run(list, 4); }), "the disk is full");
  EXPECT_LT(std::chrono::steady_clock::now() - begin, 5s);
  expect_no_process_left();
}

TEST(ProcessPool, ShowsHowFarTheFirstIs) {
  std::vector<std::pair<std::size_t, double>> shown;
  JobList list{.size = 2, .what = "a job"};
  list.prepare = [](std::size_t) {
    return [](const Progress& progress) {
      progress(0.5);
      progress(1);
      return std::string();
    };
  };
  list.take = [](std::size_t, const std::string&) {};
  list.progress = [&](std::size_t k) {
    return [&shown, k](double share) {
      shown.emplace_back(k, share);
      return true;
    };
  };
  ProcessPool::run(list, 1);
  ASSERT_FALSE(shown.empty());
  EXPECT_TRUE(std::is_sorted(shown.begin(), shown.end()));
  for (const auto& [k, share] : shown) EXPECT_TRUE(k < 2 && (share == 0.5 || share == 1)) << share;
}

}  // namespace
}  // namespace pyrasim
