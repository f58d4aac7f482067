// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>

namespace pyrasim::hw {

/// A point in time or a duration, in cycles of the machine's clock; the frame starts at 0.
using Cycle = std::uint64_t;

/// Later than everything: a date that nothing known so far decides.
inline constexpr Cycle never = std::numeric_limits<Cycle>::max();

}  // namespace pyrasim::hw
