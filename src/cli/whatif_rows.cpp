// SPDX-License-Identifier: Apache-2.0
#include "cli/whatif_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "cli/csv.h"
#include "cli/frame_table.h"
#include "cli/statistics_document.h"
#include "hw_model/machine_settings.h"
#include "hw_model/report/bottleneck.h"
#include "text/display_width.h"
#include "text/printable.h"
#include "version.h"

namespace pyrasim::cli {

PredictionRows::PredictionRows(hw::Cycle recorded, const std::vector<Prediction>& list)
    : recorded_(recorded), width_(std::string_view("change").size()) {
  for (const Prediction& prediction : list) {
    if (has_effect(prediction)) width_ = std::max(width_, display_width(prediction.change));
  }
}

std::string PredictionRows::table_header() const {
  return fmt::format("{:<{}} {:>18} {:>11}\n", "change", width_, "predicted cycles", "difference");
}

std::string PredictionRows::table_row(const Prediction& prediction) const {
  return fmt::format("{:<{}} {:>18} {:>+9.2f} %\n", prediction.change, width_, grouped(prediction.cycles),
                     difference_percent(prediction));
}

std::string PredictionRows::csv_row(const Prediction& prediction) const {
  return cli::csv_row(
      {prediction.change, std::to_string(prediction.cycles), fmt::format("{:.9g}", difference_percent(prediction))});
}

nlohmann::ordered_json PredictionRows::document(const Prediction& prediction) const {
  return {{"change", prediction.change},
          {"predicted_cycles", prediction.cycles},
          {"difference_percent", difference_percent(prediction)}};
}

WhatifRows::WhatifRows(std::string trace, Run run, const std::vector<WhatifPoint>& points)
    : trace_(std::move(trace)), run_(std::move(run)), width_(std::string_view("change").size()) {
  for (const WhatifPoint& point : points) width_ = std::max(width_, display_width(point.change));
}

std::string WhatifRows::table_header() const {
  return fmt::format("{:<{}} {:>14} {:>11} {:>9}  {}\n", "change", width_, "cycles", "difference", "fps", "bottleneck");
}

std::string WhatifRows::table_row(const WhatifRow& row) const {
  return fmt::format("{:<{}} {:>14} {:>+9.2f} % {:>9.1f}  {}\n", row.point.change, width_, grouped(row.outcome.cycles),
                     row.difference_percent(), frames_per_second(run_on(row), row.outcome.cycles),
                     hw::cause_text(row.outcome.bottleneck));
}

std::string WhatifRows::csv_row(const WhatifRow& row) const {
  const Run run = run_on(row);
  return cli::csv_row(
      {std::string(version()), trace_, one_line(run.scene.name),
       run.scene.sha256.empty() ? "unknown" : run.scene.sha256, hw::settings_sha256(run.machine), row.point.change,
       std::to_string(row.outcome.cycles), fmt::format("{:.9g}", row.difference_percent()),
       fmt::format("{:.9g}", frames_per_second(run, row.outcome.cycles)), hw::cause_text(row.outcome.bottleneck)});
}

nlohmann::ordered_json WhatifRows::document(const WhatifRow& row) const {
  return {{"change", row.point.change},
          {"difference_percent", row.difference_percent()},
          {"statistics", simulation_document(run_on(row), row.outcome)}};
}

Run WhatifRows::run_on(const WhatifRow& row) const {
  Run run = run_;
  run.machine = row.point.machine;
  return run;
}

}  // namespace pyrasim::cli
