// SPDX-License-Identifier: Apache-2.0
#include "cli/sweep_plan.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/command.h"
#include "error.h"
#include "pyramid/max_level.h"

namespace pyrasim::cli {
namespace {

struct Axis {
  std::string path;
  std::vector<std::string> values;
};

Axis parse_axis(const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos) return {assignment, {}};
  return {assignment.substr(0, equals), split(assignment.substr(equals + 1), ',')};
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

std::vector<Leaf> parse_leaves(const std::string& text) {
  std::vector<Leaf> list;
  for (const std::string& leaf : split(text, ',')) {
    if (leaf != "mean" && leaf != "drop") throw UsageError("--leaf " + leaf + ": mean and drop are allowed");
    list.push_back(leaf == "mean" ? Leaf::mean : Leaf::drop);
  }
  return list;
}

std::vector<Screen> parse_sizes(const std::string& text, const Screen& screen) {
  if (text.empty()) return {screen};
  std::vector<Screen> list;
  for (const std::string& size : split(text, ',')) {
    const auto [columns, rows] = parse_size(size);
    list.push_back(resized(screen, columns, rows));
  }
  return list;
}

}  // namespace pyrasim::cli
