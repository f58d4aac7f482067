// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <list>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hw_model/report/bottleneck.h"
#include "run/recorded_run.h"
#include "run/run.h"

namespace pyrasim::cli {

/// A frame on a machine, as asked for or with some settings changed.
struct BudgetFrame {
  Run run;
  std::shared_ptr<const Scene> scene;
  std::map<std::string, std::string> changed;  ///< settings and their values, to name the frame by
};

/// How a frame went, and what kept it from being faster: the end of its bottleneck chain.
struct FrameOutcome {
  hw::Cycle cycles;
  std::vector<hw::BottleneckLink> bottleneck;
};

/// What else will be tried beside a frame: other machines, for which its rays are the same, or other frames.
enum class Search { machines, frames };

/// Makes frames of one scene, each in a process of its own, and none twice. What rays see does not depend on the
/// machine: where a frame of the same size and level is recorded, it is replayed from that without tracing a ray; else
/// it is simulated. Without textures a higher level will do too: a frame's rays are some of those. Two recordings are
/// kept at a time: of the frame as asked for, and of the last other one.
class BudgetFrames {
 public:
  explicit BudgetFrames(const BudgetFrame& asked);

  /// Simulates the frame as asked for, and records it. Throws LimitError where it is not finished within `max_cycles`.
  hw::Cycle make_asked(hw::Cycle max_cycles);
  /// The frame's cycles where it keeps to its budget.
  std::optional<hw::Cycle> cycles_within_budget(const BudgetFrame& frame, Search search);
  /// Of the whole frame, without a limit.
  FrameOutcome outcome(const BudgetFrame& frame);
  /// The whole frame with its critical path; it is recorded first. The path takes ten times as long.
  Outcome critical_path(const BudgetFrame& frame);
  /// Simulates a frame that has been replayed only. Throws RunError where that takes other cycles.
  void confirm(const BudgetFrame& frame);

  std::size_t simulated() const { return simulated_; }  ///< frames whose rays were traced
  std::size_t replayed() const { return replayed_; }    ///< frames that were made from recorded rays

 private:
  /// What rays depend on.
  struct Raster {
    explicit Raster(const Run& run) : max_level(run.max_level), columns(run.screen.columns), rows(run.screen.rows) {}
    bool same_size(const Raster& other) const { return columns == other.columns && rows == other.rows; }
    friend bool operator==(const Raster&, const Raster&) = default;
    int max_level, columns, rows;
  };
  struct Known {
    Raster raster;
    hw::MachineSpec machine;  ///< but for its clock and goal, which change no cycles
    std::optional<FrameOutcome> outcome = {};
    hw::Cycle more_than = 0;  ///< cycles, where there is no outcome
    bool simulated = false;
  };
  struct Recording {
    Raster raster;
    std::optional<RecordedRun> run;  ///< none where it would have taken too much memory
  };

  Known& known(const BudgetFrame& frame);
  /// From which the frame could be made; null where there is none.
  const Recording* recording(const BudgetFrame& frame) const;
  /// What the frame can be replayed from; null where it has to be simulated.
  const RecordedRun* recorded_work(const BudgetFrame& frame) const;
  Task simulation(const BudgetFrame& frame, hw::Cycle max_cycles) const;
  Outcome record(const BudgetFrame& frame, hw::Cycle max_cycles);
  /// From recorded work where there is some. Counts it.
  Task task(const BudgetFrame& frame, hw::Cycle max_cycles);
  void make(const BudgetFrame& frame, hw::Cycle max_cycles, Search search);

  BudgetFrame asked_;
  std::shared_ptr<const Intersector> intersector_;  ///< of frames of the size that is asked for
  std::list<Known> known_;
  std::list<Recording> recordings_;
  std::size_t simulated_ = 0;
  std::size_t replayed_ = 0;
};

}  // namespace pyrasim::cli
