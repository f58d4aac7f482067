// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <functional>
#include <string>

#include "render/parallel.h"

namespace pyrasim {

/// What a process of its own does: it returns its result, and tells how far it is.
using Job = std::function<std::string(const Progress&)>;

/// Job in a process that was forked for it. For simulations: SystemC elaborates once a process, and a process that
/// dies takes nothing else along. It ends with this object, with the program, and at a signal.
class ChildProcess {
 public:
  /// `what` names the job in messages, as in "the simulation with intersection.units 256". Throws RunError where the
  /// process cannot be started.
  ChildProcess(std::string what, const Job& job);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Can be polled for what the process sends.
  int descriptor() const { return end_; }
  /// Takes what there is, waiting for it. Whether the process has ended.
  bool receive();
  /// The share of its work that the process has done, 0 to 1.
  double share() const { return share_; }
  /// What the job has returned, once receive() says that the process has ended. What it threw is thrown here, as an
  /// Error of the same exit code; RunError where the process has died, which says how.
  std::string result();

 private:
  void take_shares();
  int wait();

  std::string what_;
  pid_t child_ = 0;  ///< 0: waited for
  int end_ = -1;
  double share_ = 0;
  std::string received_;  ///< that is not understood yet: in the end, an exit code and the result or an error's message
};

}  // namespace pyrasim
