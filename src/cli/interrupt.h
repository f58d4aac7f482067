// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

namespace pyrasim::cli {

/// Runs `job`, which SIGINT and SIGTERM end at the next opportunity: it has to ask interrupted(), as progress_bar()
/// does. A second signal kills the program. Throws Interrupted with `how_far` the job came.
void run_interruptibly(const std::function<void()>& job, const std::function<std::string()>& how_far);

/// Whether a signal has asked the job to end.
bool interrupted();

}  // namespace pyrasim::cli
