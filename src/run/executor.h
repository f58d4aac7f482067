// SPDX-License-Identifier: Apache-2.0
// Makes runs in processes of their own, on this host.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "hw_model/record/recorded_work.h"
#include "run/outcome.h"
#include "run/process_pool.h"
#include "run/run.h"
#include "run/simulation.h"

namespace pyrasim {

/// One run, and what the process that makes it inherits from this one.
struct Task {
  Run run;
  std::shared_ptr<const Scene> scene;
  std::shared_ptr<const Intersector> intersector = {};        ///< as in HostOptions
  Measure measure = {};                                       ///< may be empty
  std::shared_ptr<const hw::RecordedTextures> textures = {};  ///< as in HostOptions
  bool critical_path = false;                                 ///< likewise
  bool occupancies = false;                                   ///< as in HostOptions
};

/// A list of runs, numbered from 0, and what becomes of their outcomes.
struct TaskList {
  std::size_t size = 0;
  std::string what;  ///< as in JobList
  /// Called in order, each just before its run begins. None: there is nothing to run, and no outcome.
  std::function<std::optional<Task>(std::size_t)> prepare = {};
  /// Called in order, as soon as an outcome and all before it are known.
  std::function<void(std::size_t, const std::optional<Outcome>&)> take = {};
  std::function<Progress(std::size_t)> progress = {};  ///< as in JobList
};

/// Makes all of them, `at_once` at the same time; the same is taken whatever that is. A frame that is not finished is a
/// failure. Throws as ProcessPool::run() does.
void execute(const TaskList& list, int at_once);

/// Makes one run; `what` names it. A frame that is not finished is an outcome. Throws likewise.
Outcome execute(const Task& task, const std::string& what);

/// An outcome, and what the frame's rays and nodes took.
struct RecordedOutcome {
  Outcome outcome;
  std::optional<hw::RecordedWork> work;  ///< none where the frame is not finished, or it would be too many numbers
};

/// Makes one run likewise, of a task that has its intersector, and records its work in `most` numbers or fewer.
RecordedOutcome execute_recorded(const Task& task, const std::string& what, std::size_t most);

}  // namespace pyrasim
