// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "cli/frame_table.h"
#include "cli/statistics_document.h"
#include "hw_model/report/bottleneck.h"

namespace pyrasim::cli {
namespace {

std::string unit_lines(const hw::Processor& processor) {
  std::string text =
      fmt::format("\n{:<24}  {:>7}  {:>7}  {:>7}  {:>7}\n", "unit", "busy", "starved", "blocked", "idle");
  const auto cycles = static_cast<double>(processor.cycles());
  for (const hw::Stage* stage : processor.stages()) {
    const hw::StageStatistics unit = stage->statistics(processor.cycles());
    const auto percent = [cycles](hw::Cycle part) { return 100 * static_cast<double>(part) / cycles; };
    text += fmt::format("{:<24}  {:>5.1f} %  {:>5.1f} %  {:>5.1f} %  {:>5.1f} %\n", stage->basename(),
                        percent(unit.busy), percent(unit.starved), percent(unit.blocked), percent(unit.idle));
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
      fmt::format("{}, MAX_LEVEL {}, on machine {}\n\n", frame_title(scene, camera), max_level, spec.name);
  text += frame_lines(processor.statistics(), max_level);
  text += unit_lines(processor);
  text += fmt::format("\ncycles        {:>12}   {:.1f} frames per second at {} MHz\n", grouped(processor.cycles()),
                      frames_per_second(processor), spec.clock_mhz);
  text += bottleneck_lines(processor) + latency_line(processor);
  text += fmt::format("budget        {:>12}   for {} frames per second: {}\n", grouped(spec.budget()), spec.goal_fps,
                      met ? "met" : "missed");
  return text;
}

}  // namespace pyrasim::cli
