// SPDX-License-Identifier: Apache-2.0
// The colour of a terminal node of the trace tree.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <vector>

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

/// The scene's colours as the colour unit holds them.
class Palette {
 public:
  explicit Palette(const Scene& scene) {
    for (const Object& object : scene.objects) colors_.push_back(object.color);
    background_ = fixed(scene.background, 1, 4);
    background_color_ = scene.background;
    lights_ = scene.lights.has_value();
  }

  /// The integral colour over the pyramid (decision D6): for case 2 the object's colour times the mean shading of the
  /// four corners, for case 1 the background, for case 3 at MAX_LEVEL as `edge` says. Corners that face each other are
  /// summed first: the mean of a mirrored or transposed pixel is the same, bit for bit.
  FixedColor terminal_color(PyramidCase which, const CornerSamples& corners, EdgePolicy edge) const {
    if (which == PyramidCase::covered) {
      const glm::dvec3& color = colors_[corners[0].seen.object];
      if (lights_) return fixed(lit(color, mean(corners, &Shading::light)), 1, 4);
      return fixed(color, mean(corners, &Shading::factor), 4);
    }
    if (which == PyramidCase::empty || edge == EdgePolicy::drop) return background_;
    FixedColor sum{};
    for (const Sample& corner : corners) {
      const FixedColor part = sample_color(corner, 1);
      for (std::size_t k = 0; k < 3; ++k) sum[k] += part[k];
    }
    return sum;
  }

  /// The colour of one sample, times `quarters` / 4.
  FixedColor sample_color(const Sample& sample, std::int64_t quarters = 4) const {
    if (sample.seen.object == no_object) return fixed(background_color_, 1, quarters);
    const glm::dvec3& color = colors_[sample.seen.object];
    if (lights_) return fixed(lit(color, sample.shading.light()), 1, quarters);
    return fixed(color, sample.shading.factor(), quarters);
  }

 private:
  template <class Part>
  static Part mean(const CornerSamples& corners, Part (Shading::*of)() const) {
    const auto part = [&](std::size_t corner) { return (corners[corner].shading.*of)(); };
    return ((part(0) + part(3)) + (part(1) + part(2))) / 4.0;
  }
  static glm::dvec3 lit(const glm::dvec3& color, const glm::dvec3& light) {
    return glm::min(color * light, glm::dvec3(max_color));
  }
  /// color * shading, rounded to a multiple of 2^-48, times quarters / 4.
  static FixedColor fixed(const glm::dvec3& color, double shading, std::int64_t quarters) {
    constexpr double unit = 1LL << (fixed_color_bits - 2);
    return {quarters * std::llrint(color.x * shading * unit), quarters * std::llrint(color.y * shading * unit),
            quarters * std::llrint(color.z * shading * unit)};
  }

  std::vector<glm::dvec3> colors_;
  FixedColor background_{};
  glm::dvec3 background_color_{};
  bool lights_ = false;  ///< the scene has a list of them
};

}  // namespace pyrasim
