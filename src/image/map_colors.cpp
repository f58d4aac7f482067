// SPDX-License-Identifier: Apache-2.0
#include "image/map_colors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <map>

#include "image/srgb.h"

namespace pyrasim {

glm::vec3 linear_from_srgb_bytes(int red, int green, int blue) {
  const auto linear = [](int component) { return static_cast<float>(linear_from_srgb(component / 255.0)); };
  return {linear(red), linear(green), linear(blue)};
}

glm::vec3 heat_color(double share) {
  constexpr std::array<std::array<int, 3>, 6> stops{
      {{10, 8, 34}, {72, 18, 106}, {150, 38, 98}, {218, 76, 58}, {248, 158, 46}, {252, 252, 186}}};
  const double place = std::clamp(share, 0.0, 1.0) * (stops.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), stops.size() - 2);
  const auto stop = [&](std::size_t k) { return glm::vec3(stops[k][0], stops[k][1], stops[k][2]); };
  const glm::vec3 signal =
      glm::mix(stop(below), stop(below + 1), static_cast<float>(place - static_cast<double>(below)));
  const auto linear = [](float component) { return static_cast<float>(linear_from_srgb(component / 255.0)); };
  return {linear(signal.x), linear(signal.y), linear(signal.z)};
}

HeatScale heat_scale(const std::vector<std::uint64_t>& values) {
  if (values.empty()) return {};
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return {*least, *most};
}

Image heat_map(const std::vector<std::uint64_t>& values, int columns, int rows) {
  const auto [least, most] = heat_scale(values);
  const auto logarithm = [](std::uint64_t value) {
    return std::log(static_cast<double>(std::max<std::uint64_t>(value, 1)));
  };
  const double from = logarithm(least);
  const double range = logarithm(most) - from;
  std::map<std::uint64_t, glm::vec3> colors;  // few numbers occur often
  Image image(columns, rows);
  for (std::size_t k = 0; k < values.size(); ++k) {
    const auto [color, fresh] = colors.try_emplace(values[k]);
    if (fresh) color->second = heat_color(range > 0 ? (logarithm(values[k]) - from) / range : 0);
    image.pixels()[k] = color->second;
  }
  return image;
}

}  // namespace pyrasim
