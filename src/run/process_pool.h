// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <exception>
#include <functional>
#include <list>
#include <map>
#include <string>
#include <variant>

#include "run/child_process.h"

namespace pyrasim {

/// Jobs, numbered from 0, and what becomes of their results.
struct JobList {
  std::size_t size = 0;
  std::string what;  ///< names a job in the message on a process that dies
  /// Called in this process in order, each just before its job is started. Empty: there is nothing to do, and the
  /// result is an empty text.
  std::function<Job(std::size_t)> prepare = {};
  /// Called in order, as soon as a result and all before it are known.
  std::function<void(std::size_t, const std::string& result)> take = {};
  /// Shows how far a job is; asked for where it is the first whose result is not known. May be empty.
  std::function<Progress(std::size_t)> progress = {};
};

/// Does jobs in processes of their own, so many at once. Whatever that number is, the same is taken: where a job fails,
/// the results before it are taken, and then its Error is thrown.
class ProcessPool {
 public:
  /// Does all of them, `at_once` at the same time. Throws what prepare(), take() and the jobs throw, the first in
  /// order; Stopped (interrupt.h) where the user interrupts. No process is left then.
  static void run(const JobList& list, int at_once);

 private:
  struct Member {
    Member(std::size_t its_number, const std::string& what, const Job& job) : number(its_number), process(what, job) {}
    std::size_t number;
    ChildProcess process;
  };
  using Result = std::variant<std::string, std::exception_ptr>;

  ProcessPool(const JobList& list, int at_once)
      : list_(list), at_once_(static_cast<std::size_t>(at_once)), end_(list.size) {}
  void start_next();
  void take_known();
  void receive();
  void end(Member& member);
  void know(std::size_t number, Result result);
  void show_progress();

  const JobList& list_;
  std::size_t at_once_;
  std::size_t end_;          ///< jobs from it on are not started: one before has failed
  std::size_t started_ = 0;  ///< and those before
  std::size_t taken_ = 0;    ///< and those before
  std::list<Member> running_;
  std::map<std::size_t, Result> known_;  ///< that are not taken
  std::size_t shown_ = 0;                ///< whose progress bar_ is
  Progress bar_;
};

}  // namespace pyrasim
