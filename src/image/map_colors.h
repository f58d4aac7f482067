// SPDX-License-Identifier: Apache-2.0
// What maps show numbers as.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "image/image.h"

namespace pyrasim {

/// The linear RGB of sRGB components from 0 to 255.
glm::vec3 linear_from_srgb_bytes(int red, int green, int blue);

/// From dark (0) over violet, red and orange to light yellow (1), in linear RGB: lighter is more, in print too.
glm::vec3 heat_color(double share);

/// The least and the most of a map's numbers: its darkest and its lightest colour.
struct HeatScale {
  std::uint64_t least = 0;
  std::uint64_t most = 0;
};
HeatScale heat_scale(const std::vector<std::uint64_t>& values);

/// A picture of `values`, row by row, the colours in between by their logarithms.
Image heat_map(const std::vector<std::uint64_t>& values, int columns, int rows);

}  // namespace pyrasim
