// SPDX-License-Identifier: Apache-2.0
// Which changes make a frame meet its budget: of one setting, and of two together.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cli/budget_frames.h"

namespace pyrasim::cli {

/// A setting that can be changed for speed, in steps of 1.
struct BudgetSetting {
  std::string name;
  int largest_change;  ///< the value beyond which it cannot be changed
  std::function<int(const BudgetFrame&)> get;
  std::function<void(BudgetFrame&, int)> set;
  std::function<std::string(const BudgetFrame&)> value;  ///< for people
  Search search = Search::machines;
  bool doubles = false;       ///< try twice as much first: the largest change is slow to simulate
  bool keeps_cycles = false;  ///< it makes cycles shorter, not fewer

  BudgetFrame with(BudgetFrame frame, int value) const;
  bool can_change(const BudgetFrame& frame) const { return get(frame) != largest_change; }
};

/// Units, clock, MAX_LEVEL and size.
std::vector<BudgetSetting> budget_settings(const BudgetFrame& frame);
/// A whole number of the machine, up to what it may be; none where machines have no such setting.
std::optional<BudgetSetting> machine_setting(const BudgetFrame& frame, const std::string& path);
/// The initiation interval of a stage of the machine; none where `unit` is no stage that has one above 1.
std::optional<BudgetSetting> interval_setting(const BudgetFrame& frame, const std::string& unit);

/// A change that meets the budget.
struct EnoughChange {
  BudgetFrame frame;
  hw::Cycle cycles;
};

/// The smallest change of `setting` with which `frame`, which misses its budget, meets it; none where no change of it
/// is enough. By bisection: the smallest if every larger one is enough too.
std::optional<EnoughChange> smallest_change(const BudgetSetting& setting, const BudgetFrame& frame,
                                            BudgetFrames& frames);

/// Of two settings: the smallest change of `second` that is enough beside the largest of `first`, and then the smallest
/// of `first` that is enough beside that. None where both are not enough at their largest.
std::optional<EnoughChange> smallest_pair(const BudgetSetting& first, const BudgetSetting& second,
                                          const BudgetFrame& frame, BudgetFrames& frames);

}  // namespace pyrasim::cli
