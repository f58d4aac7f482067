// SPDX-License-Identifier: Apache-2.0
// Pictures as textures: texels of one colour each, and means over footprints by the area that each texel has in them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "image/image.h"
#include "texture/footprint.h"
#include "texture/texture_work.h"

namespace pyrasim {

/// What lies beside the picture.
enum class Wrap : std::uint8_t {
  repeat,  ///< it again
  clamp,   ///< its border
};

/// A picture over the cell from (0, 0), its lower left corner, to (1, 1).
class ImageTexture {
 public:
  ImageTexture(Image image, Wrap wrap);

  glm::dvec3 at(const TexturePoint& place) const;
  /// The mean over a footprint, exactly: with Green's theorem, the integral of the running sums of texels' rows around
  /// it, in a step for each line between texels that its sides cross. A footprint of a repeated picture whose sides
  /// cross more than 2^16 lines has the whole picture's mean. Adds the steps.
  glm::dvec3 mean(const Footprint& footprint, TextureWork& work) const;
  /// Over the whole picture.
  const glm::dvec3& mean() const { return mean_; }

 private:
  struct Texel {
    double column, row;  ///< whole numbers, of the plane that the picture covers by its wrap; rows from below
  };
  glm::dvec3 color(const Texel& of) const;
  /// Of the picture itself; rows from below.
  glm::dvec3 texel(std::size_t row, std::size_t column) const;
  /// Of the texels of a row before `column`.
  glm::dvec3 sum_before(std::size_t row, std::size_t column) const;
  /// The integral of a row's colours from the picture's left side to `u`, in columns; it has a bend at each column.
  glm::dvec3 along_row(double u, double row) const;
  glm::dvec3 along_side(const TexturePoint& from, const TexturePoint& to, double reference, TextureWork& work) const;
  /// Of rows and columns, what lies within the picture.
  double within(double index, int count) const;

  Image image_;
  Wrap wrap_;
  std::vector<glm::dvec3> sums_;  ///< of each row, from below, before every eighth column
  glm::dvec3 mean_{0};
};

}  // namespace pyrasim
