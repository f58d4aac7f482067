// SPDX-License-Identifier: Apache-2.0
// What a pyramid covers of a texture.
#pragma once

#include <array>
#include <cstddef>

namespace pyrasim {

/// A place on a texture, in cells of it: squares, stripes or whole images.
struct TexturePoint {
  double u = 0;
  double v = 0;
};

/// The quadrilateral between four places, which follow each other around it.
using Footprint = std::array<TexturePoint, 4>;

/// Twice its signed area; that of its points beyond the first from the first on, so that small ones far away have one.
inline double twice_area(const Footprint& footprint) {
  double sum = 0;
  for (std::size_t k = 2; k < footprint.size(); ++k) {
    const TexturePoint& a = footprint[0];
    const TexturePoint& b = footprint[k - 1];
    const TexturePoint& c = footprint[k];
    sum += (b.u - a.u) * (c.v - a.v) - (c.u - a.u) * (b.v - a.v);
  }
  return sum;
}

}  // namespace pyrasim
