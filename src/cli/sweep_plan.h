// SPDX-License-Identifier: Apache-2.0
// Which frames a sweep simulates, on which machines.
#pragma once

#include <string>
#include <vector>

#include "cli/machine_options.h"
#include "pyramid/terminal_color.h"
#include "scene/scene.h"

namespace pyrasim::cli {

/// One machine of the sweep.
struct SweptMachine {
  hw::MachineSpec spec;
  std::vector<std::string> values;  ///< that the axes have here, in their order
  std::string set;                  ///< what was set over the machine file, as "intersection.units=2 fifos.all=8"
};

/// The machines that --set asks for: where it gives a setting several values, separated by commas, each of them with
/// each of the other settings'.
struct MachineAxes {
  std::vector<std::string> paths;  ///< of the settings with several values
  std::vector<SweptMachine> machines;

  /// Throws as hw::load_machine does. Of a setting that is given twice the last one counts.
  explicit MachineAxes(const MachineOptions& options);
};

/// "0:5" or "0,2,3". Throws UsageError.
std::vector<int> parse_levels(const std::string& text);
/// "mean,drop". Throws UsageError.
std::vector<EdgePolicy> parse_edges(const std::string& text);
/// "640x480,320x240"; empty: `screen` as it is. Throws UsageError.
std::vector<Screen> parse_sizes(const std::string& text, const Screen& screen);

}  // namespace pyrasim::cli
