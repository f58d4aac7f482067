// SPDX-License-Identifier: Apache-2.0
#include "cli/budget_frames.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <malloc.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "error.h"
#include "run/executor.h"

namespace pyrasim::cli {
namespace {

constexpr std::size_t most_recorded = std::size_t{1} << 25U;  ///< numbers of a recording: 128 MiB

std::string name_of(const BudgetFrame& frame) {
  std::vector<std::string> changes;
  for (const auto& [setting, value] : frame.changed) changes.push_back(fmt::format("{} {}", setting, value));
  return changes.empty() ? "the simulation" : fmt::format("the simulation with {}", fmt::join(changes, ", "));
}

/// Of frames of this size: its hierarchy is for what is on the screen.
std::shared_ptr<const Intersector> intersector_of(const BudgetFrame& frame) {
  Scene seen = *frame.scene;
  seen.camera.screen = frame.run.screen;
  return make_intersector(seen, frame.run.formats.intersection);
}

Task replay(const BudgetFrame& frame, const RecordedRun& recorded, hw::Cycle max_cycles) {
  Task task = recorded.on(frame.run.machine);
  task.run.max_level = frame.run.max_level;
  task.run.max_cycles = max_cycles;
  return task;
}

}  // namespace

BudgetFrames::BudgetFrames(const BudgetFrame& asked) : asked_(asked), intersector_(intersector_of(asked)) {}

hw::Cycle BudgetFrames::make_asked(hw::Cycle max_cycles) {
  const Outcome outcome = record(asked_, max_cycles);
  require_finished(outcome);
  return outcome.cycles;
}

std::optional<hw::Cycle> BudgetFrames::cycles_within_budget(const BudgetFrame& frame, Search search) {
  const hw::Cycle budget = frame.run.machine.budget();
  const Known& frames = known(frame);
  if (!frames.outcome && frames.more_than < budget) make(frame, budget, search);
  return frames.outcome && frames.outcome->cycles <= budget ? std::optional(frames.outcome->cycles) : std::nullopt;
}

FrameOutcome BudgetFrames::outcome(const BudgetFrame& frame) {
  if (!known(frame).outcome) make(frame, hw::never, Search::frames);
  return *known(frame).outcome;
}

Outcome BudgetFrames::critical_path(const BudgetFrame& frame) {
  if (recording(frame) == nullptr) record(frame, hw::never);
  Task with_path = task(frame, hw::never);
  with_path.critical_path = true;
  return execute(with_path, name_of(frame));
}

void BudgetFrames::confirm(const BudgetFrame& frame) {
  Known& replayed = known(frame);
  if (replayed.simulated) return;
  ++simulated_;
  const Outcome outcome = execute(simulation(frame, hw::never), name_of(frame));
  if (outcome.cycles != replayed.outcome->cycles) {
    throw RunError(fmt::format("internal error: {} took {} cycles, and {} when it was replayed", name_of(frame),
                               outcome.cycles, replayed.outcome->cycles));
  }
  replayed.simulated = true;
}

Task BudgetFrames::simulation(const BudgetFrame& frame, hw::Cycle max_cycles) const {
  const bool same_size = Raster(frame.run).same_size(Raster(asked_.run));
  Task task{frame.run, frame.scene, same_size ? intersector_ : nullptr};
  task.run.max_cycles = max_cycles;
  return task;
}

BudgetFrames::Known& BudgetFrames::known(const BudgetFrame& frame) {
  Known wanted{Raster(frame.run), frame.run.machine};
  wanted.machine.clock_mhz = wanted.machine.goal_fps = 1;
  const auto found = std::find_if(known_.begin(), known_.end(), [&](const Known& other) {
    return other.raster == wanted.raster && other.machine == wanted.machine;
  });
  return found != known_.end() ? *found : known_.emplace_back(std::move(wanted));
}

const BudgetFrames::Recording* BudgetFrames::recording(const BudgetFrame& frame) const {
  const Raster wanted(frame.run);
  const auto found = std::find_if(recordings_.begin(), recordings_.end(), [&](const Recording& recording) {
    const bool has_more = recording.raster.max_level > wanted.max_level && recording.run && !recording.run->textures;
    return recording.raster.same_size(wanted) && (recording.raster.max_level == wanted.max_level || has_more);
  });
  return found != recordings_.end() ? &*found : nullptr;
}

const RecordedRun* BudgetFrames::recorded_work(const BudgetFrame& frame) const {
  const Recording* const found = recording(frame);
  return found != nullptr && found->run ? &*found->run : nullptr;
}

Outcome BudgetFrames::record(const BudgetFrame& frame, hw::Cycle max_cycles) {
  Task task = simulation(frame, max_cycles);
  if (!task.intersector) task.intersector = intersector_of(frame);
  ++simulated_;
  auto [outcome, work] = execute_recorded(task, name_of(frame), most_recorded);
  if (!outcome.unfinished.empty()) return outcome;
  if (recordings_.size() == 2) recordings_.pop_back();
  recordings_.push_back({Raster(frame.run), std::nullopt});
  if (work) {
    recordings_.back().run = recorded_run(frame.run, *frame.scene, task.intersector->contents(), outcome, *work);
    work.reset();
    malloc_trim(0);  // every further process would begin with a copy of what this took meanwhile
  }
  Known& frames = known(frame);
  frames.outcome = {outcome.cycles, outcome.bottleneck};
  frames.simulated = true;
  return outcome;
}

Task BudgetFrames::task(const BudgetFrame& frame, hw::Cycle max_cycles) {
  const RecordedRun* const work = recorded_work(frame);
  ++(work != nullptr ? replayed_ : simulated_);
  return work != nullptr ? replay(frame, *work, max_cycles) : simulation(frame, max_cycles);
}

void BudgetFrames::make(const BudgetFrame& frame, hw::Cycle max_cycles, Search search) {
  if (recording(frame) == nullptr && search == Search::machines) {
    record(frame, hw::never);
    return;
  }
  const Outcome outcome = execute(task(frame, max_cycles), name_of(frame));
  Known& frames = known(frame);
  if (outcome.unfinished.empty()) {
    frames.outcome = {outcome.cycles, outcome.bottleneck};
    frames.simulated = recorded_work(frame) == nullptr;
  } else {
    frames.more_than = max_cycles;
  }
}

}  // namespace pyrasim::cli
