// SPDX-License-Identifier: Apache-2.0
#include "cli/budget_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <type_traits>

#include "hw_model/machine_settings.h"

namespace pyrasim::cli {
namespace {

constexpr int most_mhz = 1'000'000;  ///< that a machine file may say

/// The clock changes no cycles, so that one simulation tells which one is needed.
std::optional<EnoughChange> smallest_clock(const BudgetSetting& clock, const BudgetFrame& frame, BudgetFrames& frames) {
  const auto cycles = frames.cycles_within_budget(clock.with(frame, clock.largest_change), Search::frames);
  if (!cycles) return std::nullopt;
  const double least = std::ceil(static_cast<double>(*cycles) * frame.run.machine.goal_fps / 1e6);
  BudgetFrame changed = clock.with(frame, static_cast<int>(std::min<double>(least, clock.largest_change)));
  return EnoughChange{std::move(changed), *cycles};
}

BudgetSetting clock_setting() {
  return {.name = "clock_mhz",
          .largest_change = most_mhz,
          .get = [](const BudgetFrame& frame) { return static_cast<int>(frame.run.machine.clock_mhz); },
          .set = [](BudgetFrame& frame, int value) { frame.run.machine.clock_mhz = value; },
          .value = [](const BudgetFrame& frame) { return fmt::format("{}", frame.run.machine.clock_mhz); },
          .keeps_cycles = true};
}

BudgetSetting level_setting() {
  return {.name = "max_level",
          .largest_change = 0,
          .get = [](const BudgetFrame& frame) { return frame.run.max_level; },
          .set = [](BudgetFrame& frame, int value) { frame.run.max_level = value; },
          .value = [](const BudgetFrame& frame) { return std::to_string(frame.run.max_level); },
          .search = Search::frames};
}

/// By the screen's columns; the rows follow.
BudgetSetting size_setting(const Screen& asked) {
  const auto set = [asked](BudgetFrame& frame, int columns) {
    const auto rows = std::lround(static_cast<double>(columns) * asked.rows / asked.columns);
    frame.run.screen = resized(asked, columns, std::max(1, static_cast<int>(rows)));
  };
  const auto value = [](const BudgetFrame& frame) {
    return fmt::format("{}x{}", frame.run.screen.columns, frame.run.screen.rows);
  };
  return {.name = "size",
          .largest_change = 1,
          .get = [](const BudgetFrame& frame) { return frame.run.screen.columns; },
          .set = set,
          .value = value,
          .search = Search::frames};
}

/// Of a machine, a whole number.
struct WholeSetting {
  hw::Cycle* value;
  int most;
};

/// None where machines have no such setting.
std::optional<WholeSetting> whole_setting(hw::MachineSpec& spec, const std::string& path) {
  std::optional<WholeSetting> found;
  hw::for_each_setting(spec, [&](const std::string& its_path, auto& setting, const auto& allowed) {
    if constexpr (std::is_same_v<decltype(setting), hw::Cycle&>) {
      if (std::string_view(its_path) == path) found = {&setting, static_cast<int>(allowed.max)};
    }
  });
  return found;
}

}  // namespace

BudgetFrame BudgetSetting::with(BudgetFrame frame, int value_of_it) const {
  set(frame, value_of_it);
  frame.changed[name] = value(frame);
  return frame;
}

std::vector<BudgetSetting> budget_settings(const BudgetFrame& frame) {
  return {*machine_setting(frame, "intersection.units"), clock_setting(), level_setting(),
          size_setting(frame.run.screen)};
}

std::optional<BudgetSetting> machine_setting(const BudgetFrame& frame, const std::string& path) {
  hw::MachineSpec of_frame = frame.run.machine;
  const auto setting = whole_setting(of_frame, path);
  if (!setting) return std::nullopt;
  const auto get = [path](const BudgetFrame& of) {
    hw::MachineSpec spec = of.run.machine;
    return static_cast<int>(*whole_setting(spec, path)->value);
  };
  const auto set = [path](BudgetFrame& of, int value) {
    *whole_setting(of.run.machine, path)->value = static_cast<hw::Cycle>(value);
  };
  return BudgetSetting{.name = path,
                       .largest_change = setting->most,
                       .get = get,
                       .set = set,
                       .value = [get](const BudgetFrame& of) { return std::to_string(get(of)); },
                       .doubles = true};
}

std::optional<BudgetSetting> interval_setting(const BudgetFrame& frame, const std::string& unit) {
  auto setting = machine_setting(frame, unit + ".interval");
  if (!setting || setting->get(frame) == 1) return std::nullopt;
  setting->largest_change = 1;
  setting->doubles = false;
  return setting;
}

std::optional<EnoughChange> smallest_change(const BudgetSetting& setting, const BudgetFrame& frame,
                                            BudgetFrames& frames) {
  if (!setting.can_change(frame)) return std::nullopt;
  if (setting.keeps_cycles) return smallest_clock(setting, frame, frames);
  int from = setting.get(frame);
  int to = setting.doubles ? std::min(2 * from, setting.largest_change) : setting.largest_change;
  const auto cycles_at = [&](int value) {
    return frames.cycles_within_budget(setting.with(frame, value), setting.search);
  };
  std::optional<hw::Cycle> cycles = cycles_at(to);
  while (!cycles && to != setting.largest_change) {
    from = to;
    to = std::min(2 * from, setting.largest_change);
    cycles = cycles_at(to);
  }
  if (!cycles) return std::nullopt;
  while (std::abs(to - from) > 1) {
    const int middle = from + (to - from) / 2;
    if (const auto found = cycles_at(middle)) {
      to = middle;
      cycles = found;
    } else {
      from = middle;
    }
  }
  return EnoughChange{setting.with(frame, to), *cycles};
}

std::optional<EnoughChange> smallest_pair(const BudgetSetting& first, const BudgetSetting& second,
                                          const BudgetFrame& frame, BudgetFrames& frames) {
  const auto beside_largest = smallest_change(second, first.with(frame, first.largest_change), frames);
  if (!beside_largest) return std::nullopt;
  return smallest_change(first, second.with(frame, second.get(beside_largest->frame)), frames);
}

}  // namespace pyrasim::cli
