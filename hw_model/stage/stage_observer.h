// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "hw_model/cycle.h"

namespace pyrasim::hw {

/// Told how a stage spends its time; spans ascend and do not overlap.
class StageObserver {
 public:
  enum class State : std::uint8_t { idle, busy, starved, blocked };
  virtual ~StageObserver() = default;
  virtual void span(State state, Cycle from, Cycle to) = 0;
};

}  // namespace pyrasim::hw
