// SPDX-License-Identifier: Apache-2.0
// The wave that stripes and checkers are made of, and its integrals.
#pragma once

#include <cmath>

namespace pyrasim {

/// +1 where floor(x) is even, -1 where it is odd.
inline double square_wave(double x) { return std::fmod(std::floor(x), 2) == 0 ? 1 : -1; }

/// Its integral from 0 on: how far the next even number is, from 0 to 1. Exact near 0.
inline double triangle_wave(double x) { return std::abs(x - 2 * std::round(x / 2)); }

/// The mean of triangle_wave() from `a` to `b`. Near each other they are integrated piece by piece, as wide as they
/// are; else by a function of period 2 whose derivative is triangle_wave() less its mean.
inline double mean_of_triangle_wave(double a, double b) {
  if (a > b) return mean_of_triangle_wave(b, a);
  const auto integral = [](double x) {
    const double part = x - 2 * std::floor(x / 2);
    return part < 1 ? 0.5 * part * (part - 1) : 0.5 * (part - 1) * (2 - part);
  };
  if (b - a > 2) return 0.5 + (integral(b) - integral(a)) / (b - a);
  double sum = 0;
  double from = a;
  for (double kink = std::floor(a) + 1; from < b; ++kink) {
    const double to = kink < b ? kink : b;
    sum += 0.5 * (triangle_wave(from) + triangle_wave(to)) * (to - from);
    from = to;
  }
  return b > a ? sum / (b - a) : triangle_wave(a);
}

}  // namespace pyrasim
