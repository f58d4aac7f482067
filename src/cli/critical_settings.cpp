// SPDX-License-Identifier: Apache-2.0
#include "cli/critical_settings.h"

#include <algorithm>
#include <string>
#include <string_view>

#include "cli/sensitivity.h"

namespace pyrasim::cli {
namespace {

constexpr std::size_t most_predicted = 3;
constexpr int most_columns = 80;  ///< of a frame whose critical path is asked for
// Shares of the frame's cycles.
constexpr double noticeable = 0.05;
constexpr double worth_a_try = 0.01;

constexpr std::string_view interval = ".interval";

/// Whether a designer can have it for room or money alone.
bool is_for_sale(std::string_view path, std::string_view step) {
  return step == "x2" || (step == "-1" && path.ends_with(interval));
}

/// The frame, not too large for its critical path.
BudgetFrame small(const BudgetFrame& asked, const std::vector<BudgetSetting>& tried) {
  const auto size = std::ranges::find(tried, "size", &BudgetSetting::name);
  return size->get(asked) <= most_columns ? asked : size->with(asked, most_columns);
}

/// Those of which something is expected, the most of the first.
std::vector<std::string> promising(const BudgetFrame& frame, BudgetFrames& frames,
                                   const std::vector<BudgetSetting>& tried) {
  const Outcome outcome = frames.critical_path(frame);
  std::vector<std::string> paths;
  const auto add = [&](const std::string& path) {
    const auto is_it = [&](const BudgetSetting& setting) { return setting.name == path; };
    if (std::none_of(tried.begin(), tried.end(), is_it) && std::ranges::count(paths, path) == 0) paths.push_back(path);
  };
  for (const Prediction& prediction : predictions(frame.run, outcome)) {
    if (prediction.cycles >= outcome.cycles || paths.size() == most_predicted) break;
    const std::size_t end = prediction.change.find('=');
    const std::string path = prediction.change.substr(0, end);
    if (is_for_sale(path, std::string_view(prediction.change).substr(end + 1))) add(path);
  }
  for (const char* const pool : {"tree_accumulator.pixels", "subdivision_controller.pool"}) add(pool);
  return paths;
}

/// Whether the frame, which took `before` cycles, takes less by that share, or is within its budget for the first time.
bool improves(const BudgetFrame& frame, hw::Cycle before, hw::Cycle after, double share) {
  const hw::Cycle budget = frame.run.machine.budget();
  return static_cast<double>(after) <= (1 - share) * static_cast<double>(before) ||
         (after <= budget && before > budget);
}

/// Doubled for as long as that helps; none where it does not.
std::optional<BudgetSetting> depth_setting(const BudgetFrame& frame, BudgetFrames& frames, const std::string& path) {
  auto setting = machine_setting(frame, path);
  const int most = setting->largest_change;
  const int now = setting->largest_change = setting->get(frame);
  hw::Cycle cycles = frames.outcome(frame).cycles;
  for (int twice = 2 * now; twice > now && twice <= most; twice *= 2) {
    const hw::Cycle after = frames.outcome(setting->with(frame, twice)).cycles;
    if (!improves(frame, cycles, after, worth_a_try)) break;
    setting->largest_change = twice;
    cycles = after;
  }
  return setting->can_change(frame) ? setting : std::nullopt;
}

/// None where it takes less than that share off the frame's cycles.
std::optional<BudgetSetting> helping_setting(const BudgetFrame& frame, BudgetFrames& frames, const std::string& path,
                                             double share) {
  const auto setting = path.ends_with(interval) ? interval_setting(frame, path.substr(0, path.size() - interval.size()))
                                                : depth_setting(frame, frames, path);
  if (!setting) return std::nullopt;
  const hw::Cycle after = frames.outcome(setting->with(frame, setting->largest_change)).cycles;
  return improves(frame, frames.outcome(frame).cycles, after, share) ? setting : std::nullopt;
}

}  // namespace

std::vector<BudgetSetting> critical_settings(const BudgetFrame& asked, BudgetFrames& frames,
                                             const std::vector<BudgetSetting>& tried) {
  const BudgetFrame first = small(asked, tried);
  std::vector<BudgetSetting> settings;
  for (const std::string& path : promising(first, frames, tried)) {
    if (!helping_setting(first, frames, path, worth_a_try)) continue;
    if (const auto setting = helping_setting(asked, frames, path, noticeable)) settings.push_back(*setting);
  }
  return settings;
}

}  // namespace pyrasim::cli
