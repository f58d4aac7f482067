// SPDX-License-Identifier: Apache-2.0
#include "pyramid/terminal_color.h"

#include <algorithm>
#include <glm/common.hpp>

#include "texture/textured_object.h"

namespace pyrasim {
namespace {

/// No brighter than pictures can be.
glm::dvec3 reflected(const glm::dvec3& color, const glm::dvec3& light) {
  return glm::min(color * light, glm::dvec3(max_color));
}

}  // namespace

Palette::Palette(const Scene& scene, std::int64_t steps, TextureFilter filter)
    : background_(fixed(scene.background, 1, 4)),
      background_color_(scene.background),
      lights_(scene.lights.has_value()),
      filter_(filter),
      view_vectors_(scene.camera.screen, steps) {
  for (const Object& object : scene.objects) {
    colors_.push_back(object.color);
    textures_ = textures_ || object.texture != nullptr;
  }
  if (!textures_) return;
  for (std::size_t k = 0; k < scene.objects.size(); ++k) {
    textured_.push_back(scene.objects[k].texture ? std::make_shared<const TexturedObject>(scene, k) : nullptr);
  }
}

glm::dvec3 Palette::light_of(const Sample& sample) const {
  return lights_ ? sample.shading.light() : glm::dvec3(sample.shading.factor());
}

FixedColor Palette::lit(const CornerSamples& corners, const Cell& cell, TextureWork& work) const {
  const glm::dvec3 light =
      ((light_of(corners[0]) + light_of(corners[3])) + (light_of(corners[1]) + light_of(corners[2]))) / 4.0;
  const std::uint32_t object = corners[0].seen.object;
  glm::dvec3 color = colors_[object];
  if (textures_ && textured_[object]) {
    std::array<glm::dvec3, 4> rays{};
    for (std::size_t k = 0; k < rays.size(); ++k) rays[k] = view_vectors_(corner_of(cell, k));
    color *= textured_[object]->color_over(rays, filter_, work);
  }
  return fixed(reflected(color, light), 1, 4);
}

FixedColor Palette::lit(const Sample& sample, GridPoint point, TextureWork& work, std::int64_t quarters) const {
  glm::dvec3 color = colors_[sample.seen.object];
  if (textures_ && textured_[sample.seen.object]) {
    color *= textured_[sample.seen.object]->color_at(view_vectors_(point), work);
  }
  return fixed(reflected(color, light_of(sample)), 1, quarters);
}

}  // namespace pyrasim
