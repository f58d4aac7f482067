// SPDX-License-Identifier: Apache-2.0
#include "cli/compare_runs.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "cli/command.h"
#include "error.h"
#include "json/json_file.h"

namespace pyrasim::cli {
namespace {

using nlohmann::json;

bool is_named(const json& element) {
  return element.is_object() && element.contains("name") && element["name"].is_string();
}

constexpr std::array<std::string_view, 11> settings{"scene",           "columns", "rows",   "window", "method",
                                                    "max_level",       "edge",    "scalar", "engine", "machine.name",
                                                    "machine.settings"};

/// What is asked most of a run comes first.
constexpr std::array<std::string_view, 12> results{"machine",        "rays",  "cases",         "subdivisions",
                                                   "terminal_nodes", "work",  "rays_by_reuse", "arithmetic",
                                                   "pixel_latency",  "units", "fifos",         "bottleneck"};

/// The place of the first of `sections` that `path` belongs to; their number where it belongs to none.
template <class Sections>
std::size_t place_among(const Sections& sections, const std::string& path) {
  const auto holds = [&](std::string_view section) {
    return path == section || path.starts_with(std::string(section) + ".");
  };
  return static_cast<std::size_t>(std::find_if(sections.begin(), sections.end(), holds) - sections.begin());
}

std::size_t rank(const std::string& path) {
  const std::size_t setting = place_among(settings, path);
  return setting < settings.size() ? setting : settings.size() + place_among(results, path);
}

/// What cannot but differ, says nothing about the result, or repeats a setting.
bool is_aside(const std::string& path) {
  constexpr std::array<std::string_view, 5> aside{"command", "pyrasim", "machine.settings_sha256", "machine.clock_mhz",
                                                  "machine.budget.goal_fps"};
  return std::find(aside.begin(), aside.end(), path) != aside.end();
}

}  // namespace

bool is_setting(const std::string& path) { return place_among(settings, path) < settings.size(); }

RunFile::RunFile(const std::string& name) : file_(name), document_(read_json_file(name)) {
  const bool is_run = document_.is_object() && document_.contains("pyrasim") && document_.contains("rays") &&
                      document_.contains("image");
  if (!is_run) {
    throw InputError(json_message(file_, "", "it is not the statistics of a run",
                                  "what --stats of render or simulate writes is allowed"));
  }
  collect(document_, "");
}

const json* RunFile::at(const std::string& path) const {
  const auto found = values_.find(path);
  return found == values_.end() ? nullptr : found->second;
}

void RunFile::collect(const json& value, const std::string& path) {
  const std::string prefix = path.empty() ? "" : path + ".";
  if (value.is_object()) {
    for (const auto& [key, member] : value.items()) collect(member, prefix + key);
  } else if (value.is_array() && !value.empty() && std::all_of(value.begin(), value.end(), is_named)) {
    for (const json& element : value) {
      const std::string name = prefix + element["name"].get<std::string>() + ".";
      for (const auto& [key, member] : element.items()) {
        if (key != "name") collect(member, name + key);
      }
    }
  } else if (value.is_array() && path.ends_with("by_level")) {
    for (std::size_t level = 0; level < value.size(); ++level) collect(value[level], prefix + std::to_string(level));
  } else if (values_.emplace(path, &value).second) {
    paths_.push_back(path);
  }
}

std::vector<Difference> differences(const RunFile& first, const RunFile& second) {
  std::vector<Difference> found;
  for (const std::string& path : first.paths()) {
    const json* value = first.at(path);
    const json* other = second.at(path);
    if (!is_aside(path) && (other == nullptr || *other != *value)) found.push_back({path, value, other});
  }
  for (const std::string& path : second.paths()) {
    if (!is_aside(path) && first.at(path) == nullptr) found.push_back({path, nullptr, second.at(path)});
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Difference& a, const Difference& b) { return rank(a.path) < rank(b.path); });
  return found;
}

nlohmann::ordered_json comparison_document(const RunFile& first, const RunFile& second) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Difference& difference : differences(first, second)) {
    list.push_back({{"path", difference.path}});
    if (difference.first != nullptr) list.back()["first"] = *difference.first;
    if (difference.second != nullptr) list.back()["second"] = *difference.second;
  }
  return {{"command", command_line()},
          {"first", first.file()},
          {"second", second.file()},
          {"equal", list.empty()},
          {"differences", list}};
}

}  // namespace pyrasim::cli
