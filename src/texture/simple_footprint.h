// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "texture/footprint.h"

namespace pyrasim {

/// Calls side(from, to) for each of the footprint's.
template <class Side>
void for_each_side(const Footprint& footprint, const Side& side) {
  for (std::size_t k = 0; k < footprint.size(); ++k) side(footprint[k], footprint[(k + 1) % footprint.size()]);
}

/// The mean over a footprint where `mean` knows that over a quadrilateral with an area whose sides do not cross, and
/// `point` the texture at a place: one that has no area to speak of is the mean of its corners; one that crosses itself
/// its two triangles.
template <class Mean, class Point>
auto mean_of_any(const Footprint& footprint, const Mean& mean, const Point& point) -> decltype(point(footprint[0])) {
  using Result = decltype(point(footprint[0]));
  const auto [a, b, c, d] = footprint;
  const double first = twice_area({a, b, c, c});
  const double second = twice_area({a, c, d, d});
  const double size = std::max({std::abs(b.u - a.u), std::abs(b.v - a.v), std::abs(c.u - a.u), std::abs(c.v - a.v),
                                std::abs(d.u - a.u), std::abs(d.v - a.v)});
  const double least = 1e-13 * size * size;
  const bool has_first = std::abs(first) > least;
  const bool has_second = std::abs(second) > least;
  if (!has_first && !has_second) return ((point(a) + point(c)) + (point(b) + point(d))) * 0.25;
  if (first * second >= 0) return mean(footprint);
  Result sum(0);
  if (has_first) sum += mean(Footprint{a, b, c, c}) * std::abs(first);
  if (has_second) sum += mean(Footprint{a, c, d, d}) * std::abs(second);
  return sum / (std::abs(first) + std::abs(second));
}

}  // namespace pyrasim
