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
constexpr int most_times = 64;    ///< as deep
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

bool less_by(double share, hw::Cycle before, hw::Cycle after) {
  return static_cast<double>(after) <= (1 - share) * static_cast<double>(before);
}

/// Doubled for as long as that helps; none where it does not.
std::optional<BudgetSetting> depth_setting(const BudgetFrame& frame, BudgetFrames& frames, const std::string& path) {
  auto setting = machine_setting(frame, path);
  const int most = setting->largest_change;
  const int now = setting->get(frame);
  setting->largest_change = now;
  hw::Cycle cycles = frames.outcome(frame).cycles;
  for (int times = 2; times <= most_times && times * now <= most; times *= 2) {
    const hw::Cycle after = frames.outcome(setting->with(frame, times * now)).cycles;
    if (!less_by(worth_a_try, cycles, after)) break;
    setting->largest_change = times * now;
    cycles = after;
  }
  return setting->can_change(frame) ? setting : std::nullopt;
}

/// None where it does not help.
std::optional<BudgetSetting> helping_setting(const BudgetFrame& frame, BudgetFrames& frames, const std::string& path) {
  if (!path.ends_with(interval)) return depth_setting(frame, frames, path);
  auto setting = interval_setting(frame, path.substr(0, path.size() - interval.size()));
  if (!setting) return std::nullopt;
  const hw::Cycle after = frames.outcome(setting->with(frame, setting->largest_change)).cycles;
  return less_by(worth_a_try, frames.outcome(frame).cycles, after) ? setting : std::nullopt;
}

/// Whether its largest change is worth a line: noticeable, or enough.
bool is_worth_showing(const BudgetSetting& setting, const BudgetFrame& frame, BudgetFrames& frames) {
  const hw::Cycle after = frames.outcome(setting.with(frame, setting.largest_change)).cycles;
  return after <= frame.run.machine.budget() || less_by(noticeable, frames.outcome(frame).cycles, after);
}

}  // namespace

std::vector<BudgetSetting> critical_settings(const BudgetFrame& asked, BudgetFrames& frames,
                                             const std::vector<BudgetSetting>& tried) {
  const BudgetFrame first = small(asked, tried);
  std::vector<BudgetSetting> settings;
  for (const std::string& path : promising(first, frames, tried)) {
    const auto setting = helping_setting(first, frames, path);
    if (setting && is_worth_showing(*setting, asked, frames)) settings.push_back(*setting);
  }
  return settings;
}

}  // namespace pyrasim::cli
