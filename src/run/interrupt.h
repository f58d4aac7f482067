// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

namespace pyrasim {

/// Runs `job`, which SIGINT and SIGTERM end at the next opportunity: it has to ask interrupted(), as progress_bar()
/// does, or throws Stopped. Where no opportunity comes within a second the program ends all the same; a second signal
/// kills it. Throws Interrupted with `how_far` the job came.
void run_interruptibly(const std::function<void()>& job, const std::function<std::string()>& how_far);

/// Whether a signal has asked the job to end.
bool interrupted();

/// What a job throws that cannot go on because of a signal.
struct Stopped {};
/// Throws Stopped where a signal has asked the job to end.
void stop_if_interrupted();

/// In a process that was forked inside of a job: signals end it at once.
void end_at_signals();

}  // namespace pyrasim
