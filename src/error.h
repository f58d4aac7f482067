// SPDX-License-Identifier: Apache-2.0
// The user's mistakes and a run's failures: each becomes one line on stderr and an exit code.
#pragma once

#include <stdexcept>
#include <string>

namespace pyrasim {

enum ExitCode : int {
  exit_ok = 0,
  exit_run_failed = 1,
  exit_usage = 2,
  exit_input = 3,
  exit_limit = 4,
  exit_signal = 128
};

/// An error that ends the program with `exit_code` and one line: its message.
class Error : public std::runtime_error {
 public:
  Error(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
  ExitCode exit_code() const { return code_; }

 private:
  ExitCode code_;
};

/// A run that could not be finished: an output that cannot be written, for instance.
struct RunError : Error {
  explicit RunError(const std::string& message) : Error(exit_run_failed, message) {}
};

/// A command line that asks for something that does not exist or is out of range.
struct UsageError : Error {
  explicit UsageError(const std::string& message) : Error(exit_usage, message) {}
};

/// A file that cannot be used. The message reads "FILE: /json/pointer: what is wrong; what is allowed".
struct InputError : Error {
  explicit InputError(const std::string& message) : Error(exit_input, message) {}
};

/// A deadlock, a limit on cycles that was reached, or a picture larger than memory.
struct LimitError : Error {
  explicit LimitError(const std::string& message) : Error(exit_limit, message) {}
};

/// Throws the Error of `code`; a LimitError where that is its code, which may be of several lines.
[[noreturn]] inline void throw_error(ExitCode code, const std::string& message) {
  if (code == exit_limit) throw LimitError(message);
  throw Error(code, message);
}

/// A run that its user ended by a signal. The exit code is the one that a shell reports: 130 for Ctrl-C.
struct Interrupted : Error {
  Interrupted(int signal, const std::string& how_far)
      : Error(static_cast<ExitCode>(exit_signal + signal), "interrupted " + how_far) {}
};

}  // namespace pyrasim
