// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "cli/command.h"
#include "cli/machine_options.h"
#include "run/run.h"

namespace pyrasim::cli {

/// The run of one frame that a command line asks for, and its scene.
struct AskedRun {
  Run run;
  std::shared_ptr<const Scene> scene;
};

/// Reads scene and machine, and checks all that can be known before the run: throws UsageError, InputError, LimitError.
/// Warnings go to stderr.
AskedRun asked_run(const FrameOptions& frame, const MachineOptions& machine);

/// The scene's name and the SHA-256 of what it was read from.
SceneFiles files_of(const std::string& name, const Scene& scene);

}  // namespace pyrasim::cli
