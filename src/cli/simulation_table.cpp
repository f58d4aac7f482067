// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "cli/frame_table.h"
#include "cli/statistics_document.h"
#include "hw_model/report/bottleneck.h"
#include "text/printable.h"

namespace pyrasim::cli {
namespace {

/// Units of one kind, a line of the table.
struct UnitLine {
  std::string name;
  std::vector<hw::StageStatistics> units;
};

std::vector<UnitLine> unit_groups(const hw::Processor& processor) {
  std::vector<UnitLine> lines;
  for (const hw::Stage* stage : processor.stages()) {
    const hw::StageStatistics unit = stage->statistics(processor.cycles());
    const bool is_like_others = dynamic_cast<const hw::IntersectionUnit*>(stage) != nullptr;
    if (is_like_others && lines.back().name.starts_with("intersection_unit")) {
      lines.back().units.push_back(unit);
      lines.back().name = fmt::format("intersection_units 0-{}", lines.back().units.size() - 1);
    } else {
      lines.push_back({stage->basename(), {unit}});
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

std::string unit_lines(const hw::Processor& processor) {
  using Unit = hw::StageStatistics;
  std::string text =
      fmt::format("\n{:<24}  {:>12}  {:>12}  {:>12}  {:>12}\n", "unit", "busy", "starved", "blocked", "idle");
  for (const UnitLine& line : unit_groups(processor)) {
    const auto part = [&](hw::Cycle Unit::*cycles) { return percentages(line.units, cycles, processor.cycles()); };
    text += fmt::format("{:<24}  {:>12}  {:>12}  {:>12}  {:>12}\n", line.name, part(&Unit::busy), part(&Unit::starved),
                        part(&Unit::blocked), part(&Unit::idle));
  }
  for (const hw::OmittedUnit& unit : processor.omitted()) {
    text += fmt::format("not built: {}; {}\n", unit.name, unit.reason);
  }
  return text;
}

std::string latency_line(const hw::Processor& processor) {
  hw::LatencyHistogram all;
  for (const hw::LatencyHistogram& level : processor.tree_accumulator().latencies()) all += level;
  return fmt::format("pixel latency {:>12}   cycles at the median, {} at 99 %, {} at most\n",
                     grouped(all.percentile(0.5)), grouped(all.percentile(0.99)), grouped(all.max()));
}

std::string slowest_pixel_lines(const hw::Processor& processor) {
  std::string text;
  for (const hw::FinishedPixel& pixel : processor.tree_accumulator().slowest().list()) {
    const auto [row, column] = processor.place_of(pixel.pixel);
    text += fmt::format("{:<13} {:>12}   cycles at row {}, column {}; level {}\n", text.empty() ? "slowest" : "",
                        grouped(pixel.latency), row, column, pixel.deepest);
  }
  return text;
}

std::string bottleneck_lines(const hw::Processor& processor) {
  const hw::LowerBound bound = hw::lower_bound(processor);
  return fmt::format("lower bound   {:>12}   cycles, the work of the {}: {:.1f} % of what the frame took\n",
                     grouped(bound.cycles), bound.unit,
                     100 * static_cast<double>(bound.cycles) / static_cast<double>(processor.cycles())) +
         fmt::format("bottleneck    {}\n", hw::bottleneck_text(hw::bottleneck_chain(processor)));
}

}  // namespace

std::string simulation_table(const std::string& scene, const Camera& camera, int max_level,
                             const hw::Processor& processor) {
  const hw::MachineSpec& spec = processor.spec();
  const bool met = processor.cycles() <= spec.budget();
  std::string text =
      fmt::format("{}, MAX_LEVEL {}, on machine {}\n\n", frame_title(scene, camera), max_level, excerpt(spec.title()));
  text += frame_lines(processor.statistics(), max_level);
  text += unit_lines(processor);
  text += fmt::format("\ncycles        {:>12}   {:.1f} frames per second at {} MHz\n", grouped(processor.cycles()),
                      frames_per_second(processor), spec.clock_mhz);
  text += bottleneck_lines(processor) + latency_line(processor) + slowest_pixel_lines(processor);
  text += fmt::format("budget        {:>12}   for {} frames per second: {}\n", grouped(spec.budget()), spec.goal_fps,
                      met ? "met" : "missed");
  return text;
}

}  // namespace pyrasim::cli
