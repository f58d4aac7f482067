// SPDX-License-Identifier: Apache-2.0
#include "run/executor.h"

#include <nlohmann/json.hpp>

#include "run/outcome_json.h"

namespace pyrasim {
namespace {

Job job_of(const Task& task, bool has_to_finish) {
  return [=](const Progress& progress) {
    const HostOptions host{.intersector = task.intersector,
                           .progress = progress,
                           .textures = task.textures,
                           .occupancies = task.occupancies,
                           .critical_path = task.critical_path};
    const Outcome outcome = simulate(task.run, *task.scene, host, task.measure);
    if (has_to_finish) require_finished(outcome);
    return pack(outcome).dump();
  };
}

Outcome outcome_of(const std::string& result) { return unpack(nlohmann::json::parse(result)); }

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

Outcome execute(const Task& task, const std::string& what) {
  Outcome outcome;
  JobList jobs{.size = 1, .what = what};
  jobs.prepare = [&](std::size_t) { return job_of(task, false); };
  jobs.take = [&](std::size_t, const std::string& result) { outcome = outcome_of(result); };
  ProcessPool::run(jobs, 1);
  return outcome;
}

}  // namespace pyrasim
