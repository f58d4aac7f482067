// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "cli/compare_runs.h"
#include "cli/frame_table.h"
#include "text/display_width.h"
#include "text/printable.h"

namespace pyrasim::cli {
namespace {

using nlohmann::json;

std::string shown(const json* value) {
  if (value == nullptr) return "-";
  if (value->is_number_unsigned()) return grouped(value->get<std::uint64_t>());
  if (value->is_number()) return fmt::format("{:.6g}", value->get<double>());
  return one_line(value->is_string() ? value->get<std::string>()
                                     : value->dump(-1, ' ', true, json::error_handler_t::replace));
}

bool are_numbers(const Difference& difference) {
  return difference.first != nullptr && difference.second != nullptr && difference.first->is_number() &&
         difference.second->is_number();
}

/// "+12.5 %" of the first; nothing of a setting, and where the first is 0 or no number.
std::string change(const Difference& difference) {
  if (is_setting(difference.path) || !are_numbers(difference)) return "";
  const double first = difference.first->get<double>();
  return first == 0 ? "" : fmt::format("{:+.1f} %", 100 * (difference.second->get<double>() - first) / first);
}

bool is_list(const json* value) { return value != nullptr && value->is_array(); }

/// One run as the columns of a matrix need it.
class Columns {
 public:
  explicit Columns(const RunFile& run) : run_(run) {}

  /// Of a unit or FIFO: a share of the frame's cycles, in percent.
  std::string percent(const std::string& path) const {
    const json* cycles = run_.at("machine.cycles");
    const json* part = run_.at(path);
    if (part == nullptr || !part->is_number() || cycles == nullptr || !cycles->is_number()) return "-";
    return fmt::format("{:.1f}", 100 * part->get<double>() / std::max(1.0, cycles->get<double>()));
  }
  std::string number(const std::string& path) const {
    const json* value = run_.at(path);
    return value != nullptr && value->is_number_float() ? fmt::format("{:.2f}", value->get<double>()) : shown(value);
  }

 private:
  const RunFile& run_;
};

using Cells = std::vector<std::string>;

/// Rows of one length as lines: the first column to the left, the others to the right.
std::string aligned(const std::vector<Cells>& rows) {
  std::vector<std::size_t> widths(rows.front().size());
  for (const Cells& row : rows) {
    for (std::size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], display_width(row[k]));
  }
  std::string text;
  for (const Cells& row : rows) {
    std::string line = fmt::format("{:<{}}", row.front(), widths.front());
    for (std::size_t k = 1; k < row.size(); ++k) line += fmt::format("  {:>{}}", row[k], widths[k]);
    text += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
  }
  return text;
}

struct Column {
  const char* key;
  const char* title;
  std::string (Columns::*text)(const std::string&) const;
};

/// The elements of the list `section` that differ in one of the columns.
std::vector<std::string> names_of(const std::vector<Difference>& found, const std::string& section,
                                  const std::vector<Column>& columns) {
  std::vector<std::string> names;
  for (const Difference& difference : found) {
    if (!difference.path.starts_with(section)) continue;
    for (const Column& column : columns) {
      const std::string end = std::string(".") + column.key;
      if (!difference.path.ends_with(end)) continue;
      const std::string name =
          difference.path.substr(section.size(), difference.path.size() - section.size() - end.size());
      if (names.empty() || names.back() != name) names.push_back(name);
    }
  }
  return names;
}

/// A line for each element in which something differs; a cell is "FIRST -> SECOND", or one value where both show the
/// same.
std::string matrix(const RunFile& first, const RunFile& second, const std::vector<Difference>& found,
                   const std::string& section, const std::string& title, const std::vector<Column>& columns) {
  std::vector<Cells> rows(1, Cells{title});
  for (const Column& column : columns) rows.front().emplace_back(column.title);
  for (const std::string& name : names_of(found, section, columns)) {
    Cells& row = rows.emplace_back(Cells{one_line(name)});
    for (const Column& column : columns) {
      const std::string path = fmt::format("{}{}.{}", section, name, column.key);
      const std::string from = (Columns(first).*column.text)(path);
      const std::string to = (Columns(second).*column.text)(path);
      row.push_back(from == to ? from : fmt::format("{} -> {}", from, to));
    }
  }
  return rows.size() == 1 ? "" : '\n' + aligned(rows);
}

/// What is shown in another way than a value a line, or would be too many lines.
bool has_no_line(const Difference& difference) {
  const auto begins = [&](const char* section) { return difference.path.starts_with(section); };
  return is_list(difference.first) || is_list(difference.second) || begins("units.") || begins("fifos.") ||
         begins("pixel_latency.by_level.") || difference.path == "image.sha256";
}

std::string value_lines(const std::vector<Difference>& found) {
  std::vector<Cells> rows{{"value", "first", "second", "change"}};
  for (const Difference& difference : found) {
    if (has_no_line(difference)) continue;
    rows.push_back({one_line(difference.path), shown(difference.first), shown(difference.second), change(difference)});
  }
  return rows.size() == 1 ? "" : '\n' + aligned(rows);
}

/// A rendering has no machine: all of that is in one run alone, and no difference worth a line.
std::string leave_out_machine(const RunFile& first, const RunFile& second, std::vector<Difference>& found) {
  const bool simulated = first.at("machine.cycles") != nullptr;
  if (simulated == (second.at("machine.cycles") != nullptr)) return "";
  std::erase_if(found, [](const Difference& each) { return each.first == nullptr || each.second == nullptr; });
  return fmt::format("\nonly the {} run was simulated: what both have is compared\n", simulated ? "first" : "second");
}

std::string chain_text(const RunFile& run) {
  std::string text;
  const json* chain = run.at("bottleneck.chain");
  if (!is_list(chain)) return "-";
  for (const json& link : *chain) {
    if (link.is_object() && link.contains("unit")) text += (text.empty() ? "" : " <- ") + shown(&link["unit"]);
  }
  return text;
}

std::string run_line(const char* which, const RunFile& run) {
  return fmt::format("{:<7} {}: {}\n", which, one_line(run.file()), shown(run.at("command")));
}

}  // namespace

std::string comparison_table(const RunFile& first, const RunFile& second) {
  const std::string runs = run_line("first", first) + run_line("second", second);
  std::vector<Difference> found = differences(first, second);
  if (found.empty()) return runs + "\nequal in every setting, count and cycle; the pictures are the same\n";
  std::string text = runs + leave_out_machine(first, second, found);
  if (found.empty()) return text + "equal in all of that; the pictures are the same\n";
  text += value_lines(found);
  text += matrix(first, second, found, "units.", "unit: % of the frame's cycles",
                 {{"busy", "busy", &Columns::percent},
                  {"starved", "starved", &Columns::percent},
                  {"blocked", "blocked", &Columns::percent},
                  {"idle", "idle", &Columns::percent}});
  text += matrix(first, second, found, "fifos.", "FIFO: tokens; waits in % of the frame's cycles",
                 {{"depth", "depth", &Columns::number},
                  {"max", "most", &Columns::number},
                  {"mean", "mean", &Columns::number},
                  {"reader_starved", "reader starved", &Columns::percent},
                  {"writer_blocked", "writer blocked", &Columns::percent}});
  const std::string from = chain_text(first);
  const std::string to = chain_text(second);
  if (from != to && from != "-" && to != "-")
    text += fmt::format("\nbottleneck  first   {}\n            second  {}\n", from, to);
  const bool same_picture = std::none_of(
      found.begin(), found.end(), [](const Difference& difference) { return difference.path == "image.sha256"; });
  return text + fmt::format("\nthe pictures {}; --stats FILE writes every difference, lists included, as JSON\n",
                            same_picture ? "are the same" : "differ");
}

}  // namespace pyrasim::cli
