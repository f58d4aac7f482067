// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "cli/budget_search.h"

namespace pyrasim::cli {

/// Of depths, pools and intervals those that make the frame as asked for noticeably faster, up to as far as they make
/// it so in a small size: the few that its critical path there predicts the most of, and the pools, whose use no path
/// foresees.
/// Without those that are `tried`, of which the size is one.
std::vector<BudgetSetting> critical_settings(const BudgetFrame& asked, BudgetFrames& frames,
                                             const std::vector<BudgetSetting>& tried);

}  // namespace pyrasim::cli
