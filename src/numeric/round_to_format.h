// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "numeric/number_format.h"

namespace pyrasim {

/// The function that gives the nearest value of `format`, held in double; none for double itself. Counts
/// arithmetic_events. A fixed-point value of more than 53 bits comes out as the double nearest to it.
using RoundToFormat = double (*)(double);
RoundToFormat rounding_to(const NumberFormat& format);

}  // namespace pyrasim
