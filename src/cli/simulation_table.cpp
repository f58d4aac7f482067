// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <regex>
#include <string>
#include <utility>
#include <vector>

#include "cli/frame_table.h"
#include "cli/statistics_document.h"
#include "hw_model/report/critical_path.h"
#include "text/printable.h"

namespace pyrasim::cli {
namespace {

/// Units of one box, a line of the table.
struct UnitLine {
  std::string box;
  std::string name;
  std::vector<hw::StageStatistics> units;
};

std::vector<UnitLine> unit_groups(const Outcome& outcome) {
  std::vector<UnitLine> lines;
  for (const UnitAccount& unit : outcome.units) {
    if (!lines.empty() && unit.box == lines.back().box) {
      lines.back().units.push_back(unit.cycles);
      lines.back().name = fmt::format("{} 0-{}", unit.box, lines.back().units.size() - 1);
    } else {
      lines.push_back({unit.box, unit.name, {unit.cycles}});
    }
  }
  return lines;
}

/// "97.1-99.6 %": the least and the most of some units' shares of `cycles`.
std::string percentages(const std::vector<hw::StageStatistics>& units, hw::Cycle hw::StageStatistics::*part,
                        hw::Cycle cycles) {
  const auto [least, most] = std::minmax_element(units.begin(), units.end(),
                                                 [part](const auto& a, const auto& b) { return a.*part < b.*part; });
  const auto percent = [&](const hw::StageStatistics& unit) {
    return fmt::format("{:.1f}", 100 * static_cast<double>(unit.*part) / static_cast<double>(cycles));
  };
  const std::string from = percent(*least);
  const std::string to = percent(*most);
  return from == to ? to + " %" : fmt::format("{}-{} %", from, to);
}

/// Those that are left out for the same reason on one line.
std::string omitted_lines(std::vector<hw::MachinePart> parts) {
  std::erase_if(parts, [](const hw::MachinePart& part) { return part.units > 0; });
  std::string text;
  for (std::size_t k = 0; k < parts.size();) {
    const std::string& reason = parts[k].reason;
    text += "not built: " + parts[k].name();
    while (++k < parts.size() && parts[k].reason == reason) text += ", " + parts[k].name();
    text += "; " + reason + "\n";
  }
  return text;
}

std::string unit_lines(const Outcome& outcome) {
  using Unit = hw::StageStatistics;
  std::string text =
      fmt::format("\n{:<24}  {:>12}  {:>12}  {:>12}  {:>12}\n", "unit", "busy", "starved", "blocked", "idle");
  for (const UnitLine& line : unit_groups(outcome)) {
    const auto part = [&](hw::Cycle Unit::*cycles) { return percentages(line.units, cycles, outcome.cycles); };
    text += fmt::format("{:<24}  {:>12}  {:>12}  {:>12}  {:>12}\n", line.name, part(&Unit::busy), part(&Unit::starved),
                        part(&Unit::blocked), part(&Unit::idle));
  }
  return text + omitted_lines(outcome.parts);
}

std::string latency_line(const LatencyAccount& latency) {
  return fmt::format("pixel latency {:>12}   cycles at the median, {} at 99 %, {} at most\n", grouped(latency.p50),
                     grouped(latency.p99), grouped(latency.max));
}

std::string slowest_pixel_lines(const std::vector<SlowPixel>& slowest) {
  std::string text;
  for (const SlowPixel& pixel : slowest) {
    text += fmt::format("{:<13} {:>12}   cycles at row {}, column {}; level {}\n", text.empty() ? "slowest" : "",
                        grouped(pixel.cycles), pixel.row, pixel.column, pixel.level);
  }
  return text;
}

std::string bottleneck_lines(const Outcome& outcome) {
  const hw::LowerBound& bound = outcome.lower_bound;
  return fmt::format("lower bound   {:>12}   cycles, the work of the {}: {:.1f} % of what the frame took\n",
                     grouped(bound.cycles), bound.unit,
                     100 * static_cast<double>(bound.cycles) / static_cast<double>(outcome.cycles)) +
         fmt::format("bottleneck    {}\n", hw::bottleneck_text(outcome.bottleneck));
}

/// Without the numbers of copies: "intersection_unit_3" is one of the intersection_units.
std::string place_of_copies(const Outcome& outcome, const PathAccount& account) {
  const auto unit = std::find_if(outcome.units.begin(), outcome.units.end(),
                                 [&](const UnitAccount& its) { return its.name == account.place; });
  if (unit != outcome.units.end()) return unit->box;
  static const std::regex number("_[0-9]+");
  return std::regex_replace(account.place, number, "");
}

/// The largest shares, those of copies together; the rest on one line.
std::string critical_path_lines(const Outcome& outcome) {
  constexpr std::size_t most_lines = 6;
  std::map<std::string, hw::Cycle> by_text;
  for (const PathAccount& account : outcome.critical_path) {
    by_text[hw::owed_text(account.owed, place_of_copies(outcome, account))] += account.cycles;
  }
  std::vector<std::pair<std::string, hw::Cycle>> lines(by_text.begin(), by_text.end());
  std::stable_sort(lines.begin(), lines.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
  if (lines.size() > most_lines) {
    const auto rest = lines.begin() + most_lines - 1;
    const hw::Cycle cycles = std::accumulate(rest, lines.end(), hw::Cycle{0},
                                             [](hw::Cycle sum, const auto& line) { return sum + line.second; });
    const std::string others = fmt::format("{} others", lines.end() - rest);
    lines.erase(rest, lines.end());
    lines.emplace_back(others, cycles);
  }
  std::string text;
  for (const auto& [owed, cycles] : lines) {
    text += fmt::format("{:<13} {:>12}   cycles, {:.1f} %: {}\n", text.empty() ? "critical path" : "", grouped(cycles),
                        100 * static_cast<double>(cycles) / static_cast<double>(outcome.cycles), owed);
  }
  return text;
}

}  // namespace

std::string simulation_table(const Run& run, const Outcome& outcome) {
  const hw::MachineSpec& spec = run.machine;
  const bool met = outcome.cycles <= spec.budget();
  std::string text =
      fmt::format("{}, MAX_LEVEL {}, on machine {}\n\n", frame_title(run.scene.name, run.screen, run.window),
                  run.max_level, excerpt(spec.title()));
  text += frame_lines(outcome.counts, run.max_level);
  text += unit_lines(outcome);
  text += fmt::format("\ncycles        {:>12}   {:.1f} frames per second at {} MHz\n", grouped(outcome.cycles),
                      frames_per_second(run, outcome.cycles), spec.clock_mhz);
  text += bottleneck_lines(outcome) + critical_path_lines(outcome) + latency_line(outcome.latency) +
          slowest_pixel_lines(outcome.slowest);
  text += fmt::format("budget        {:>12}   for {} {} per second: {}\n", grouped(spec.budget()), spec.goal_fps,
                      spec.goal_fps == 1 ? "frame" : "frames", met ? "met" : "missed");
  return text;
}

}  // namespace pyrasim::cli
