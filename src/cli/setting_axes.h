// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace pyrasim::cli {

/// Settings of a machine of which some have several values: "intersection.units=1,2,4", or "intersection.units=1..8"
/// for whole numbers from the one to the other. All combinations of the values are made.
struct SettingAxes {
  struct Combination {
    std::vector<std::string> assignments;  ///< "intersection.units=2"
    std::vector<std::string> values;       ///< of the axes, in their order
  };

  std::vector<std::string> paths;  ///< of the settings with several values: the axes
  std::vector<Combination> combinations;

  /// Of a setting that is given twice the last one counts.
  explicit SettingAxes(const std::vector<std::string>& assignments);
};

}  // namespace pyrasim::cli
