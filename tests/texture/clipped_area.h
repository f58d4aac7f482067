// SPDX-License-Identifier: Apache-2.0
// Means over footprints by the sum over cells, each clipped by the footprint: slow, and without closed forms.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "../numeric/extremes/formats.h"
#include "texture/footprint.h"

namespace pyrasim {

using Outline = std::vector<TexturePoint>;

/// What lies on one side of a line u or v = `at`.
template <class Coordinate>
Outline clipped(const Outline& outline, Coordinate coordinate, double at, double side) {
  Outline result;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const TexturePoint& a = outline[k];
    const TexturePoint& b = outline[(k + 1) % outline.size()];
    const double of_a = side * (coordinate(a) - at);
    const double of_b = side * (coordinate(b) - at);
    if (of_a >= 0) result.push_back(a);
    if (of_a * of_b < 0) {
      const double share = of_a / (of_a - of_b);
      result.push_back({a.u + share * (b.u - a.u), a.v + share * (b.v - a.v)});
    }
  }
  return result;
}

inline double area(const Outline& outline) {
  double sum = 0;
  for (std::size_t k = 2; k < outline.size(); ++k) {
    const TexturePoint& a = outline[0];
    const TexturePoint& b = outline[k - 1];
    const TexturePoint& c = outline[k];
    sum += 0.5 * ((b.u - a.u) * (c.v - a.v) - (c.u - a.u) * (b.v - a.v));
  }
  return sum;
}

/// The mean of value(i, j) over the cells from (i, j) to (i + 1, j + 1).
template <class Value>
double mean_by_cells(const Footprint& footprint, const Value& value) {
  const auto u = [](const TexturePoint& p) { return p.u; };
  const auto v = [](const TexturePoint& p) { return p.v; };
  const auto range = [&](const auto& coordinate) {
    const auto ends = std::minmax_element(footprint.begin(), footprint.end(),
                                          [&](const auto& a, const auto& b) { return coordinate(a) < coordinate(b); });
    return std::pair(std::floor(coordinate(*ends.first)), coordinate(*ends.second));
  };
  double sum = 0;
  double all = 0;
  const std::pair<double, double> columns = range(u);
  const std::pair<double, double> rows = range(v);
  for (double i = columns.first; i <= columns.second; ++i) {
    const Outline column = clipped(clipped({footprint.begin(), footprint.end()}, u, i, 1), u, i + 1, -1);
    for (double j = rows.first; j <= rows.second; ++j) {
      const double part = area(clipped(clipped(column, v, j, 1), v, j + 1, -1));
      all += part;
      sum += part * value(i, j);
    }
  }
  return sum / all;
}

/// A square, its corners displaced, stretched to a parallelogram, either way around, about a place near `place`.
inline Footprint random_footprint(Random& random, const TexturePoint& place, double size) {
  const double long_side = size * std::exp2(random.uniform(-1, 1));
  const double short_side = long_side * std::exp2(random.uniform(-8, 0));
  const double angle = random.uniform(0, 7);
  const TexturePoint along{long_side * std::cos(angle), long_side * std::sin(angle)};
  const TexturePoint across{-short_side * std::sin(angle), short_side * std::cos(angle)};
  constexpr std::array<std::array<double, 2>, 4> square{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  Footprint footprint;
  for (std::size_t k = 0; k < 4; ++k) {
    const double x = square[k][0] - 0.5 + random.uniform(-0.2, 0.2);
    const double y = square[k][1] - 0.5 + random.uniform(-0.2, 0.2);
    footprint[k] = {place.u + x * along.u + y * across.u, place.v + x * along.v + y * across.v};
  }
  if (random.below(2) == 0) std::reverse(footprint.begin(), footprint.end());
  return footprint;
}

}  // namespace pyrasim
