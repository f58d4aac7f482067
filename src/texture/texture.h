// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>

#include "texture/footprint.h"
#include "texture/image_texture.h"
#include "texture/texture_work.h"

namespace pyrasim {

/// What a texture is.
enum class Pattern : std::uint8_t {
  checker,  ///< squares of two colours in turn along both axes
  stripes,  ///< of two colours in turn along u
  image,    ///< a picture
};

/// Two colours that a surface has in turn, or a picture, laid out by its coordinates (surface_coordinates.h): the cell
/// from 0 to `scale` has the first colour, or the picture; it is turned counterclockwise about 0, and then shifted.
struct Texture {
  Pattern pattern = Pattern::checker;
  std::array<glm::dvec3, 2> colors{};  ///< linear RGB
  std::shared_ptr<const ImageTexture> image{};
  std::array<double, 2> scale{1, 1};  ///< of one cell, in the surface's coordinates
  std::array<double, 2> shift{0, 0};
  double turn = 0;  ///< degrees

  /// Where `u` and `v` of the surface lie, in cells.
  TexturePoint cell(double u, double v) const;
  /// At a place in cells.
  glm::dvec3 at(const TexturePoint& place) const;
  /// The mean over a footprint in cells, exactly (pattern_mean.h); adds the steps that it took.
  glm::dvec3 mean(const Footprint& footprint, TextureWork& work) const;
  /// Over all of it.
  glm::dvec3 mean() const { return image ? image->mean() : (colors[0] + colors[1]) * 0.5; }
};

/// What a terminal node takes of a texture.
enum class TextureFilter : std::uint8_t {
  integral,  ///< its mean over the pyramid's footprint (decision D6)
  point,     ///< what its four corners see
};

}  // namespace pyrasim
