// SPDX-License-Identifier: Apache-2.0
#include "texture/pattern_mean.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "texture/simple_footprint.h"
#include "texture/square_wave.h"

namespace pyrasim {
namespace {

constexpr double most_lines = 1 << 16;  ///< of all four sides

/// A footprint moved by whole cells, so that the lines next to it are those through 0, and what that does to a wave's
/// sign.
struct Moved {
  Footprint footprint;
  double sign_of_u, sign_of_v;

  explicit Moved(const Footprint& from) : footprint(from) {
    const double u = std::round(from[0].u);
    const double v = std::round(from[0].v);
    for (TexturePoint& point : footprint) point = {point.u - u, point.v - v};
    sign_of_u = square_wave(u);
    sign_of_v = square_wave(v);
  }
};

/// The integral of S(u) s(v) dv along a side.
double along_side(const TexturePoint& from, const TexturePoint& to) {
  const double rise = to.v - from.v;
  if (rise == 0) return 0;
  const double slope = (to.u - from.u) / rise;
  const double direction = rise > 0 ? 1 : -1;
  double sum = 0;
  TexturePoint here = from;
  double line = rise > 0 ? std::floor(from.v) + 1 : std::ceil(from.v) - 1;
  while (here.v != to.v) {
    const bool last = direction * (line - to.v) >= 0;
    const TexturePoint next = last ? to : TexturePoint{from.u + (line - from.v) * slope, line};
    sum += square_wave(0.5 * (here.v + next.v)) * mean_of_triangle_wave(here.u, next.u) * (next.v - here.v);
    here = next;
    line += direction;
  }
  return sum;
}

double lines_of_v(const Footprint& footprint) {
  double lines = 0;
  for_each_side(footprint, [&](const TexturePoint& a, const TexturePoint& b) {
    lines += std::abs(std::floor(b.v) - std::floor(a.v));
  });
  return lines;
}

Footprint exchanged(Footprint footprint) {
  for (auto& [u, v] : footprint) std::swap(u, v);
  return footprint;
}

/// Of a quadrilateral that does not cross itself.
double mean_of_simple_checker(const Footprint& footprint) {
  double integral = 0;
  for_each_side(footprint, [&](const TexturePoint& a, const TexturePoint& b) { integral += along_side(a, b); });
  return std::clamp(2 * integral / twice_area(footprint), -1.0, 1.0);
}

double mean_of_simple_stripes(const Footprint& footprint) {
  double integral = 0;
  for_each_side(footprint, [&](const TexturePoint& a, const TexturePoint& b) {
    integral += mean_of_triangle_wave(a.u, b.u) * (b.v - a.v);
  });
  return std::clamp(2 * integral / twice_area(footprint), -1.0, 1.0);
}

}  // namespace

PatternMean mean_of_stripes(const Footprint& footprint) {
  const Moved moved(footprint);
  if (lines_of_v(exchanged(moved.footprint)) == 0) return {square_wave(footprint[0].u)};
  return {moved.sign_of_u * mean_of_any(moved.footprint, mean_of_simple_stripes,
                                        [](const TexturePoint& point) { return square_wave(point.u); })};
}

/// Steps over the lines of v, or of u where these are fewer; but where it lies between two lines of u, over the others.
PatternMean mean_of_checker(const Footprint& footprint) {
  const Moved moved(footprint);
  const double of_v = lines_of_v(moved.footprint);
  const double of_u = lines_of_v(exchanged(moved.footprint));
  if (of_u == 0 && of_v == 0) return {square_wave(footprint[0].u) * square_wave(footprint[0].v)};
  const bool exchange = of_u == 0 || (of_v > 0 && of_u < of_v);
  const Footprint near = exchange ? exchanged(moved.footprint) : moved.footprint;
  const double lines = exchange ? of_u : of_v;
  if (!(lines <= most_lines)) return {0};
  return {moved.sign_of_u * moved.sign_of_v *
              mean_of_any(near, mean_of_simple_checker,
                          [](const TexturePoint& point) { return square_wave(point.u) * square_wave(point.v); }),
          static_cast<std::uint64_t>(lines)};
}

}  // namespace pyrasim
