// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "hw_model/cycle.h"

namespace pyrasim::hw {

/// No frame runs for longer, cycles: half of what a Cycle can count, so that dates a firing ahead of it can be told.
inline constexpr Cycle longest_frame = Cycle{1} << 63U;

/// What an engine heeds while it runs a frame.
struct RunControl {
  Cycle last;                  ///< nothing is set off after it; it may change meanwhile
  std::function<void()> poll;  ///< called now and then, whatever the machine does: it may have to stop
};

}  // namespace pyrasim::hw
