// SPDX-License-Identifier: Apache-2.0
#include "pyramid/terminal_color.h"

#include <glm/common.hpp>

namespace pyrasim {
namespace {

/// No brighter than pictures can be.
glm::dvec3 reflected(const glm::dvec3& color, const glm::dvec3& light) {
  return glm::min(color * light, glm::dvec3(max_color));
}

}  // namespace

FixedColor Palette::lit(const CornerSamples& corners) const {
  const glm::dvec3 sum = (corners[0].shading.light() + corners[3].shading.light()) +
                         (corners[1].shading.light() + corners[2].shading.light());
  return fixed(reflected(colors_[corners[0].seen.object], sum / 4.0), 1, 4);
}

FixedColor Palette::lit(const Sample& sample, std::int64_t quarters) const {
  return fixed(reflected(colors_[sample.seen.object], sample.shading.light()), 1, quarters);
}

}  // namespace pyrasim
