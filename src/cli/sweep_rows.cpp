// SPDX-License-Identifier: Apache-2.0
#include "cli/sweep_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "cli/csv.h"
#include "hw_model/machine_settings.h"
#include "text/display_width.h"
#include "text/printable.h"
#include "version.h"

namespace pyrasim::cli {

std::vector<std::string> sweep_key(const SweepPoint& point) {
  const Run& run = point.run;
  return {std::string(version()),
          one_line(run.scene.name),
          run.scene.sha256.empty() ? "unknown" : run.scene.sha256,
          one_line(run.machine.name),
          hw::settings_sha256(run.machine),
          one_line(point.set),
          std::to_string(run.screen.columns),
          std::to_string(run.screen.rows),
          std::to_string(run.max_level),
          std::string(name_of(run.edge)),
          run.reference};
}

std::string sweep_csv_row(const SweepPoint& point, const Outcome& outcome) {
  const FrameStatistics& frame = outcome.counts;
  std::vector<std::string> fields = sweep_key(point);
  for (const std::uint64_t count :
       {frame.primary_rays(), frame.subdivision_rays_traced(), frame.total_rays(), frame.subdivisions}) {
    fields.push_back(std::to_string(count));
  }
  const auto& error = outcome.error;
  fields.push_back(error ? fmt::format("{:.9g}", error->rmse) : "");
  fields.push_back(error ? fmt::format("{:.9g}", error->maximum) : "");
  fields.push_back(std::to_string(outcome.cycles));
  fields.push_back(fmt::format("{:.9g}", frames_per_second(point.run, outcome.cycles)));
  fields.push_back(error ? std::to_string(error->rays) : "");
  return csv_row(fields);
}

SweepTable::SweepTable(const std::vector<std::string>& scenes, const MachineAxes& machines) {
  if (scenes.size() > 1) {
    scene_width_ = std::string_view("scene").size();
    for (const std::string& name : scenes) scene_width_ = std::max(scene_width_, display_width(excerpt(name)));
  }
  for (std::size_t axis = 0; axis < machines.paths.size(); ++axis) {
    Column column{excerpt(machines.paths[axis]), 0};
    column.width = display_width(column.title);
    for (const SweptMachine& machine : machines.machines) {
      column.width = std::max(column.width, display_width(excerpt(machine.values[axis])));
    }
    settings_.push_back(column);
  }
}

std::string SweepTable::header() const {
  std::string text = scene_width_ > 0 ? fmt::format("{:<{}} ", "scene", scene_width_) : "";
  text += fmt::format("{:>11} {:>5} {:>4}", "size", "level", "edge");
  for (const Column& column : settings_) text += fmt::format(" {:>{}}", column.title, column.width);
  return text + fmt::format(" {:>12} {:>12} {:>10} {:>10} {:>12} {:>9}\n", "rays", "subdivisions", "RMSE", "max error",
                            "cycles", "fps");
}

std::string SweepTable::line(const SweepPoint& point, const Outcome& outcome) const {
  const Run& run = point.run;
  std::string text = scene_width_ > 0 ? fmt::format("{:<{}} ", excerpt(run.scene.name), scene_width_) : "";
  text += fmt::format("{:>11} {:>5} {:>4}", point.size(), run.max_level, pyrasim::name_of(run.edge));
  for (std::size_t k = 0; k < settings_.size(); ++k) {
    text += fmt::format(" {:>{}}", excerpt(point.values[k]), settings_[k].width);
  }
  text += fmt::format(" {:>12} {:>12}", outcome.counts.total_rays(), outcome.counts.subdivisions);
  text += outcome.error ? fmt::format(" {:>10.3e} {:>10.3e}", outcome.error->rmse, outcome.error->maximum)
                        : fmt::format(" {:>10} {:>10}", "-", "-");
  return text + fmt::format(" {:>12} {:>9.1f}\n", outcome.cycles, frames_per_second(run, outcome.cycles));
}

std::string SweepTable::name_of(const SweepPoint& point) const {
  const Run& run = point.run;
  std::string name =
      fmt::format("{} pixels, MAX_LEVEL {}, edge {}", point.size(), run.max_level, pyrasim::name_of(run.edge));
  if (scene_width_ > 0) name = excerpt(run.scene.name) + ", " + name;
  for (std::size_t k = 0; k < settings_.size(); ++k) {
    name += fmt::format(", {} {}", settings_[k].title, excerpt(point.values[k]));
  }
  return name;
}

}  // namespace pyrasim::cli
