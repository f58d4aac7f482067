// SPDX-License-Identifier: Apache-2.0
#include "run/executor.h"

#include <nlohmann/json.hpp>

#include "error.h"
#include "run/outcome_json.h"

namespace pyrasim {
namespace {

Outcome made(const Task& task, const Progress& progress, hw::WorkSink* work = nullptr) {
  const HostOptions host{.intersector = task.intersector,
                         .progress = progress,
                         .textures = task.textures,
                         .work = work,
                         .occupancies = task.occupancies,
                         .critical_path = task.critical_path};
  return simulate(task.run, *task.scene, host, task.measure);
}

Job job_of(const Task& task, bool has_to_finish) {
  return [=](const Progress& progress) {
    const Outcome outcome = made(task, progress);
    if (has_to_finish) require_finished(outcome);
    return pack(outcome).dump();
  };
}

Outcome outcome_of(const std::string& result) { return unpack(nlohmann::json::parse(result)); }

std::string result_of(const Job& job, const std::string& what) {
  std::string of_job;
  JobList jobs{.size = 1, .what = what};
  jobs.prepare = [&](std::size_t) { return job; };
  jobs.take = [&](std::size_t, const std::string& result) { of_job = result; };
  ProcessPool::run(jobs, 1);
  return of_job;
}

}  // namespace

void execute(const TaskList& list, int at_once) {
  JobList jobs{.size = list.size, .what = list.what, .progress = list.progress};
  jobs.prepare = [&](std::size_t k) {
    const std::optional<Task> task = list.prepare(k);
    return task ? job_of(*task, true) : Job();
  };
  jobs.take = [&](std::size_t k, const std::string& result) {
    list.take(k, result.empty() ? std::nullopt : std::optional(outcome_of(result)));
  };
  ProcessPool::run(jobs, at_once);
}

Outcome execute(const Task& task, const std::string& what) { return outcome_of(result_of(job_of(task, false), what)); }

/// The result is the outcome as JSON, which is one line, and then the work.
RecordedOutcome execute_recorded(const Task& task, const std::string& what, std::size_t most) {
  const SceneContents contents = task.intersector->contents();
  const auto job = [&](const Progress& progress) {
    hw::RecordedWork work(contents, most);
    const Outcome outcome = made(task, progress, &work);
    const bool recorded = outcome.unfinished.empty() && work.whole();
    return pack(outcome).dump() + '\n' + (recorded ? work.packed() : "");
  };
  const std::string result = result_of(job, what);
  const std::size_t end = result.find('\n');
  RecordedOutcome recorded{outcome_of(result.substr(0, end)), std::nullopt};
  if (end + 1 < result.size()) {
    recorded.work.emplace(contents);
    if (!recorded.work->add_packed(std::string_view(result).substr(end + 1)))
      throw RunError(what + ": its work is damaged");
  }
  return recorded;
}

}  // namespace pyrasim
