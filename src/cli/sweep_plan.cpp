// SPDX-License-Identifier: Apache-2.0
#include "cli/sweep_plan.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "cli/command.h"
#include "cli/setting_axes.h"
#include "error.h"
#include "pyramid/max_level.h"
#include "text/printable.h"

namespace pyrasim::cli {
namespace {

/// "0:5" or "0,2,3". Throws UsageError.
std::vector<int> parse_levels(const std::string& text) {
  std::vector<int> list;
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) {
    for (const std::string& level : split(text, ',')) {
      list.push_back(parse_number(level, 0, max_level_limit, "--max-level"));
    }
    return list;
  }
  const int first = parse_number(text.substr(0, colon), 0, max_level_limit, "--max-level");
  const int last = parse_number(text.substr(colon + 1), first, max_level_limit, "--max-level");
  for (int level = first; level <= last; ++level) list.push_back(level);
  return list;
}

/// "mean,drop". Throws UsageError.
std::vector<EdgePolicy> parse_edges(const std::string& text) {
  std::vector<EdgePolicy> list;
  for (const std::string& edge : split(text, ',')) {
    if (edge != "mean" && edge != "drop")
      throw UsageError("--edge " + value_excerpt(edge) + ": mean and drop are allowed");
    list.push_back(edge == "mean" ? EdgePolicy::mean : EdgePolicy::drop);
  }
  return list;
}

/// "640x480,320x240"; empty: `screen` as it is. Throws UsageError.
std::vector<Screen> parse_sizes(const std::string& text, const Screen& screen) {
  if (text.empty()) return {screen};
  std::vector<Screen> list;
  for (const std::string& size : split(text, ',')) {
    const auto [columns, rows] = parse_size(size);
    list.push_back(resized(screen, columns, rows));
  }
  return list;
}

}  // namespace

MachineAxes::MachineAxes(const MachineOptions& options) {
  SettingAxes axes(options.overrides);
  paths = std::move(axes.paths);
  for (auto& [assignments, values] : axes.combinations) {
    MachineOptions machine = options;
    machine.overrides = assignments;
    machines.push_back({machine.load(), std::move(values), fmt::format("{}", fmt::join(assignments, " "))});
  }
}

void FrameAxes::add_points(std::vector<SweepPoint>& points, const Run& run, const std::shared_ptr<const Scene>& scene,
                           const MachineAxes& machines) const {
  SweepPoint point{run, scene, {}, {}};
  for (const Screen& screen : parse_sizes(sizes, scene->camera.screen)) {
    point.run.screen = screen;
    for (const SweptMachine& machine : machines.machines) {
      point.run.machine = machine.spec;
      point.values = machine.values;
      point.set = machine.set;
      for (const EdgePolicy edge : parse_edges(edges)) {
        point.run.edge = edge;
        for (const int level : parse_levels(levels)) {
          point.run.max_level = level;
          points.push_back(point);
        }
      }
    }
  }
}

}  // namespace pyrasim::cli
