// SPDX-License-Identifier: Apache-2.0
// Which frames a sweep simulates, on which machines.
#pragma once

#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "cli/machine_options.h"
#include "run/run.h"

namespace pyrasim::cli {

/// One machine of the sweep.
struct SweptMachine {
  hw::MachineSpec spec;
  std::vector<std::string> values;  ///< that the axes have here, in their order
  std::string set;                  ///< what was set over the machine file, as "intersection.units=2 fifos.all=8"
};

/// The machines that --set asks for, as SettingAxes reads it.
struct MachineAxes {
  std::vector<std::string> paths;  ///< of the settings with several values
  std::vector<SweptMachine> machines;

  /// Throws as hw::load_machine does. Of a setting that is given twice the last one counts.
  explicit MachineAxes(const MachineOptions& options);
};

/// One row of the sweep.
struct SweepPoint {
  Run run;
  std::shared_ptr<const Scene> scene;
  std::vector<std::string> values;  ///< as in SweptMachine
  std::string set;                  ///< as in SweptMachine

  std::string size() const { return fmt::format("{}x{}", run.screen.columns, run.screen.rows); }
  /// Whether what its picture is measured against is the other's.
  bool same_reference(const SweepPoint& other) const {
    return scene == other.scene && run.screen.columns == other.run.screen.columns &&
           run.screen.rows == other.run.screen.rows;
  }
};

/// What --max-level, --size and --edge name; all combinations of it are made.
struct FrameAxes {
  std::string levels = "0:5";
  std::string sizes;  ///< empty: the scene's own
  std::string edges = "mean";

  /// The points of one scene, whose files `run` names; the other settings that they share are the run's. Throws
  /// UsageError.
  void add_points(std::vector<SweepPoint>& points, const Run& run, const std::shared_ptr<const Scene>& scene,
                  const MachineAxes& machines) const;
};

}  // namespace pyrasim::cli
