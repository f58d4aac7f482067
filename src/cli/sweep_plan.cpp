// SPDX-License-Identifier: Apache-2.0
#include "cli/sweep_plan.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>

#include "cli/command.h"
#include "error.h"
#include "pyramid/max_level.h"
#include "text/printable.h"

namespace pyrasim::cli {
namespace {

struct Axis {
  std::string path;
  std::vector<std::string> values;
};

/// Where the JSON value at the beginning of `text` is over, at the latest: at the first comma that is in no text, array
/// or object of it. What does not begin like one of these is a text up to the next comma.
std::size_t end_of_value(std::string_view text) {
  if (text.empty() || std::string_view("\"[{").find(text.front()) == std::string_view::npos) {
    return std::min(text.find(','), text.size());
  }
  int depth = 0;
  bool quoted = false;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const char c = text[k];
    if (quoted && c == '\\') {
      ++k;
    } else if (c == '"') {
      quoted = !quoted;
    } else if (!quoted) {
      if (c == ',' && depth == 0) return k;
      if (c == '[' || c == '{') ++depth;
      if (c == ']' || c == '}') --depth;
    }
  }
  return text.size();
}

std::vector<std::string> split_values(std::string_view text) {
  std::vector<std::string> values;
  for (;;) {
    const std::size_t end = end_of_value(text);
    values.emplace_back(text.substr(0, end));
    if (end == text.size()) return values;
    text.remove_prefix(end + 1);
  }
}

Axis parse_axis(const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos) return {assignment, {}};
  return {assignment.substr(0, equals), split_values(std::string_view(assignment).substr(equals + 1))};
}

std::vector<Axis> parse_axes(const std::vector<std::string>& assignments) {
  std::vector<Axis> axes;
  for (const std::string& assignment : assignments) {
    Axis axis = parse_axis(assignment);
    std::erase_if(axes, [&](const Axis& earlier) { return earlier.path == axis.path; });  // the last word counts
    axes.push_back(std::move(axis));
  }
  return axes;
}

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
  std::vector<std::vector<std::string>> combinations(1);  // of assignments
  std::vector<std::vector<std::string>> values(1);        // of the axes among them
  for (const Axis& axis : parse_axes(options.overrides)) {
    const bool several = axis.values.size() > 1;
    if (several) paths.push_back(axis.path);
    std::vector<std::vector<std::string>> longer;
    std::vector<std::vector<std::string>> longer_values;
    for (std::size_t k = 0; k < combinations.size(); ++k) {
      for (const std::string& value : axis.values.empty() ? std::vector<std::string>{""} : axis.values) {
        longer.push_back(combinations[k]);
        longer.back().push_back(axis.values.empty() ? axis.path : axis.path + "=" + value);
        longer_values.push_back(values[k]);
        if (several) longer_values.back().push_back(value);
      }
    }
    combinations.swap(longer);
    values.swap(longer_values);
  }
  for (std::size_t k = 0; k < combinations.size(); ++k) {
    MachineOptions machine = options;
    machine.overrides = combinations[k];
    machines.push_back({machine.load(), values[k], fmt::format("{}", fmt::join(combinations[k], " "))});
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
