// SPDX-License-Identifier: Apache-2.0
// Means of patterns over footprints, closed forms whatever the footprint's size.
//
// With s(x) the square wave and S an integral of it, Green's theorem makes of the integral of s(u) over a footprint
// that of S(u) dv around it, and of that of s(u) s(v) that of S(u) s(v) dv. Along a side u runs in proportion to v:
// stripes take one step a side, checkers one for each line v = whole number that it crosses.
#pragma once

#include "texture/footprint.h"

namespace pyrasim {

/// The mean of square_wave(u) over the footprint: 1 where it lies on even stripes alone, -1 on odd ones.
double mean_of_stripes(const Footprint& footprint);

/// The mean of square_wave(u) square_wave(v). A footprint of which each side crosses more than 2^22 lines has mean 0:
/// the exact one is as near, but for slivers that run along a diagonal.
double mean_of_checker(const Footprint& footprint);

/// The number of lines that the sides of the footprint cross, as mean_of_checker() steps over them.
double lines_crossed(const Footprint& footprint);

}  // namespace pyrasim
