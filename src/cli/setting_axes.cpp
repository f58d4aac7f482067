// SPDX-License-Identifier: Apache-2.0
#include "cli/setting_axes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string_view>

#include "error.h"
#include "text/parse_number.h"
#include "text/printable.h"

namespace pyrasim::cli {
namespace {

constexpr std::int64_t most_values = 1000;  ///< of a range

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

/// What is wrong with first..last; empty where nothing is.
std::string fault_of_range(std::int64_t first, std::int64_t last) {
  if (first < 0) return "it begins below 0";
  if (last < first) return fmt::format("{} is less than {}", last, first);
  if (last - first >= most_values) return "it has too many values";
  return "";
}

/// Adds the values that `text` stands for: the numbers of "1..8", else itself.
void add_values(std::vector<std::string>& values, std::string_view text, std::string_view path) {
  const std::size_t dots = text.find("..");
  std::int64_t first = 0;
  std::int64_t last = 0;
  if (dots == std::string_view::npos || !parse_whole(text.substr(0, dots), first) ||
      !parse_whole(text.substr(dots + 2), last)) {
    values.emplace_back(text);
    return;
  }
  if (const std::string fault = fault_of_range(first, last); !fault.empty()) {
    throw UsageError(fmt::format("{}={}: {}; FIRST..LAST is allowed, from 0 on, ascending and of at most {} values",
                                 excerpt(path), excerpt(text), fault, most_values));
  }
  for (std::int64_t value = first; value <= last; ++value) values.push_back(std::to_string(value));
}

std::vector<std::string> split_values(std::string_view text, std::string_view path) {
  std::vector<std::string> values;
  for (;;) {
    const std::size_t end = end_of_value(text);
    add_values(values, text.substr(0, end), path);
    if (end == text.size()) return values;
    text.remove_prefix(end + 1);
  }
}

Axis parse_axis(const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos) return {assignment, {}};
  const std::string_view text = assignment;
  return {assignment.substr(0, equals), split_values(text.substr(equals + 1), text.substr(0, equals))};
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

SettingAxes::SettingAxes(const std::vector<std::string>& assignments) : combinations(1) {
  for (const Axis& axis : parse_axes(assignments)) {
    const bool several = axis.values.size() > 1;
    if (several) paths.push_back(axis.path);
    std::vector<Combination> longer;
    for (const Combination& combination : combinations) {
      for (const std::string& value : axis.values.empty() ? std::vector<std::string>{""} : axis.values) {
        longer.push_back(combination);
        longer.back().assignments.push_back(axis.values.empty() ? axis.path : axis.path + "=" + value);
        if (several) longer.back().values.push_back(value);
      }
    }
    combinations.swap(longer);
  }
}

}  // namespace pyrasim::cli
