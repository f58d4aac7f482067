// SPDX-License-Identifier: Apache-2.0
// The colour of a terminal node of the trace tree.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include "camera/view_vector.h"
#include "pyramid/classifier.h"
#include "scene/scene.h"

namespace pyrasim {

/// What becomes of a case-3 subpixel at MAX_LEVEL (decision D2).
enum class EdgePolicy : std::uint8_t {
  mean,  ///< a terminal node with the mean of its four corner samples
  drop,  ///< no node: its area counts as background, as the article's pseudo-code reads
};

/// Linear RGB as whole multiples of 2^-50. Sums of such colours are exact, so that a tree's result does not depend on
/// the order in which its nodes arrive.
using FixedColor = std::array<std::int64_t, 3>;
inline constexpr int fixed_color_bits = 50;

class TexturedObject;

/// The scene's colours as the colour unit holds them.
class Palette {
 public:
  /// For rays through a grid of `steps` along a pixel's side.
  Palette(const Scene& scene, std::int64_t steps, TextureFilter filter = TextureFilter::integral);

  /// The integral colour over the pyramid on `cell` (decision D6): for case 2 the object's colour, and the mean of its
  /// texture over the footprint, times the mean shading of the four corners, for case 1 the background, for case 3 at
  /// MAX_LEVEL as `edge` says. Corners that face each other are summed first: the mean of a mirrored or transposed
  /// pixel is the same, bit for bit. Adds what textures take.
  FixedColor terminal_color(PyramidCase which, const CornerSamples& corners, EdgePolicy edge, const Cell& cell,
                            TextureWork& work) const {
    if (which == PyramidCase::covered) {
      if (lights_ || textures_) [[unlikely]]
        return lit(corners, cell, work);
      const double shading = ((corners[0].shading.factor() + corners[3].shading.factor()) +
                              (corners[1].shading.factor() + corners[2].shading.factor())) /
                             4;
      return fixed(colors_[corners[0].seen.object], shading, 4);
    }
    if (which == PyramidCase::empty || edge == EdgePolicy::drop) return background_;
    FixedColor sum{};
    for (std::size_t corner = 0; corner < corners.size(); ++corner) {
      const FixedColor part = sample_color(corners[corner], corner_of(cell, corner), work, 1);
      for (std::size_t k = 0; k < 3; ++k) sum[k] += part[k];
    }
    return sum;
  }

  /// The colour of one sample, of the ray through `point`, times `quarters` / 4.
  FixedColor sample_color(const Sample& sample, GridPoint point, TextureWork& work, std::int64_t quarters = 4) const {
    if (sample.seen.object == no_object) return fixed(background_color_, 1, quarters);
    if (lights_ || textures_) [[unlikely]]
      return lit(sample, point, work, quarters);
    return fixed(colors_[sample.seen.object], sample.shading.factor(), quarters);
  }

 private:
  /// The same under a list of lights, or of scenes with textures; apart, so that the others stay short.
  FixedColor lit(const CornerSamples& corners, const Cell& cell, TextureWork& work) const;
  glm::dvec3 light_of(const Sample& sample) const;
  FixedColor lit(const Sample& sample, GridPoint point, TextureWork& work, std::int64_t quarters) const;

  /// color * shading, rounded to a multiple of 2^-48, times quarters / 4.
  static FixedColor fixed(const glm::dvec3& color, double shading, std::int64_t quarters) {
    constexpr double unit = 1LL << (fixed_color_bits - 2);
    return {quarters * std::llrint(color.x * shading * unit), quarters * std::llrint(color.y * shading * unit),
            quarters * std::llrint(color.z * shading * unit)};
  }

  std::vector<glm::dvec3> colors_;
  FixedColor background_{};
  glm::dvec3 background_color_{};
  bool lights_ = false;    ///< the scene has a list of them
  bool textures_ = false;  ///< some object has one
  TextureFilter filter_;
  ViewVectors view_vectors_;                                     ///< in double: textures are no part of the datapath
  std::vector<std::shared_ptr<const TexturedObject>> textured_;  ///< by object, where it has a texture
};

}  // namespace pyrasim
