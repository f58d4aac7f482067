// SPDX-License-Identifier: Apache-2.0
// What whatif says of each machine: as CSV, as JSON, and as a table for people.
#pragma once

#include <cmath>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "cli/sensitivity.h"
#include "run/outcome.h"
#include "run/run.h"

namespace pyrasim::cli {

inline constexpr std::string_view whatif_csv_header =
    "pyrasim,trace,scene,scene_sha256,settings_sha256,change,cycles,difference_percent,frames_per_second,bottleneck\n";

/// A machine to try.
struct WhatifPoint {
  std::string change;  ///< what it is called: one line
  hw::MachineSpec machine;
};

/// And what came of it.
struct WhatifRow {
  const WhatifPoint& point;
  const Outcome& outcome;
  hw::Cycle recorded;  ///< cycles of the recorded machine

  double difference_percent() const {
    return 100 * (static_cast<double>(outcome.cycles) / static_cast<double>(recorded) - 1);
  }
};

inline constexpr std::string_view prediction_csv_header = "change,predicted_cycles,difference_percent\n";

/// Of --sensitivity, likewise.
class PredictionRows {
 public:
  PredictionRows(hw::Cycle recorded, const std::vector<Prediction>& list);

  /// Whether it is as much as a hundredth of a percent.
  bool has_effect(const Prediction& prediction) const { return std::abs(difference_percent(prediction)) >= 0.01; }
  std::string table_header() const;
  std::string table_row(const Prediction& prediction) const;
  std::string csv_row(const Prediction& prediction) const;
  nlohmann::ordered_json document(const Prediction& prediction) const;

 private:
  double difference_percent(const Prediction& prediction) const {
    return 100 * (static_cast<double>(prediction.cycles) / static_cast<double>(recorded_) - 1);
  }

  hw::Cycle recorded_;
  std::size_t width_;  ///< of the table's first column
};

class WhatifRows {
 public:
  /// `run` is the recorded one.
  WhatifRows(std::string trace, Run run, const std::vector<WhatifPoint>& points);

  std::string table_header() const;
  std::string table_row(const WhatifRow& row) const;
  std::string csv_row(const WhatifRow& row) const;
  nlohmann::ordered_json document(const WhatifRow& row) const;

 private:
  Run run_on(const WhatifRow& row) const;

  std::string trace_;
  Run run_;
  std::size_t width_;  ///< of the table's first column
};

}  // namespace pyrasim::cli
