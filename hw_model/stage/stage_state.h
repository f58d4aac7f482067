// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace pyrasim::hw {

/// How a stage spends a cycle; see StageStatistics.
enum class StageState : std::uint8_t { idle, busy, starved, blocked };

}  // namespace pyrasim::hw
