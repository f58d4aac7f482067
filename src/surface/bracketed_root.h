// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace pyrasim {

/// A function's value at a place, and half of its first and of its second derivative.
template <class Scalar>
struct Expansion {
  Scalar value;
  Scalar slope;
  Scalar curvature;
};

/// Steps of an iteration before it is taken to have converged: more than any format has bits.
inline constexpr int most_steps = 72;

/// Where f changes its sign between `positive` and `negative`, the places at which it has these signs: by Newton's
/// method from `start`, by halves wherever that leaves the bracket, and after a few steps in any case. f(s) is an
/// Expansion. In the end the bracket's ends are neighbours in the number format, or a step is less than its rounding.
template <class Scalar, class Function>
Scalar bracketed_root(const Function& f, Scalar positive, Scalar negative, Scalar start) {
  constexpr int newton_steps = 8;
  const auto between = [&](Scalar s) { return (s > positive && s < negative) || (s > negative && s < positive); };
  const auto middle = [&] { return positive + (negative - positive) / Scalar(2); };
  Scalar s = between(start) ? start : middle();
  for (int step = 0; step < most_steps && between(s); ++step) {
    const auto [value, slope, curvature] = f(s);
    (value > Scalar(0) ? positive : negative) = s;
    Scalar next = middle();
    if (step < newton_steps && slope != Scalar(0)) {
      const Scalar newton = s - value / (slope + slope);
      if (newton == s) return s;
      if (between(newton)) next = newton;
    }
    s = next;
  }
  return s;
}

}  // namespace pyrasim
