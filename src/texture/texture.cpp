// SPDX-License-Identifier: Apache-2.0
#include "texture/texture.h"

#include <cmath>
#include <numbers>

#include "texture/pattern_mean.h"
#include "texture/square_wave.h"

namespace pyrasim {
namespace {

/// Of 1, all of the first colour, to -1, all of the second.
glm::dvec3 mixed(const std::array<glm::dvec3, 2>& colors, double balance) {
  return colors[0] * (0.5 * (1 + balance)) + colors[1] * (0.5 * (1 - balance));
}

}  // namespace

TexturePoint Texture::cell(double u, double v) const {
  const double angle = turn * std::numbers::pi / 180;
  const double cosine = std::cos(angle);
  const double sine = std::sin(angle);
  const double right = u - shift[0];
  const double up = v - shift[1];
  return {(cosine * right + sine * up) / scale[0], (cosine * up - sine * right) / scale[1]};
}

glm::dvec3 Texture::at(const TexturePoint& place) const {
  if (image) return image->at(place);
  const double along_v = pattern == Pattern::checker ? square_wave(place.v) : 1;
  return mixed(colors, square_wave(place.u) * along_v);
}

glm::dvec3 Texture::mean(const Footprint& footprint, TextureWork& work) const {
  if (image) return image->mean(footprint, work);
  const auto [mean, lines] = pattern == Pattern::checker ? mean_of_checker(footprint) : mean_of_stripes(footprint);
  work.lines += lines;
  return mixed(colors, mean);
}

}  // namespace pyrasim
