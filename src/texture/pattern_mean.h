// SPDX-License-Identifier: Apache-2.0
// Means of patterns over footprints, closed forms whatever the footprint's size.
//
// With s(x) the square wave and S an integral of it, Green's theorem makes of the integral of s(u) over a footprint
// that of S(u) dv around it, and of that of s(u) s(v) that of S(u) s(v) dv. Along a side u runs in proportion to v:
// stripes take one step a side, checkers one for each line v = whole number that it crosses.
#pragma once

#include <cstdint>

#include "texture/footprint.h"

namespace pyrasim {

struct PatternMean {
  double mean;              ///< from 1, the pattern's first colour alone, to -1, its second
  std::uint64_t lines = 0;  ///< that the footprint's sides crossed, each a step
};

/// Of square_wave(u).
PatternMean mean_of_stripes(const Footprint& footprint);

/// Of square_wave(u) square_wave(v). A footprint whose sides cross more than 2^16 lines has mean 0: the exact one is as
/// near, but for slivers that run along a diagonal.
PatternMean mean_of_checker(const Footprint& footprint);

}  // namespace pyrasim
