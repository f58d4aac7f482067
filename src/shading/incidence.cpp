// SPDX-License-Identifier: Apache-2.0
#include "shading/incidence.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace pyrasim {

PreparedLights::PreparedLights(const std::vector<Light>& lights, const ObserverFrame& frame, int exponent,
                               bool shadows) {
  const double unit = std::ldexp(1.0, exponent);
  for (const Light& light : lights) {
    const bool numbered = shadows && casts_shadows(light);
    const std::optional<std::size_t> number = numbered ? std::optional(with_shadows_++) : std::nullopt;
    if (const auto* ambient = std::get_if<AmbientLight>(&light)) {
      ambient_ += ambient->color;
    } else if (const auto* sun = std::get_if<DirectionalLight>(&light)) {
      sources_.push_back({sun->color, number, true, -normalized(frame.direction(sun->direction))});
    } else {
      const auto& lamp = std::get<PointLight>(light);
      sources_.push_back({lamp.color, number, false, frame.point(lamp.position) * unit, lamp.falloff, unit});
    }
  }
}

Incidence PreparedLights::Source::at(const glm::dvec3& place) const {
  if (directional) return {where, std::numeric_limits<double>::infinity(), color};
  const glm::dvec3 way = where - place;
  const double distance = glm::length(way);
  const double in_scene = distance / unit;
  const double fading = falloff == Falloff::none ? 1 : falloff == Falloff::linear ? in_scene : in_scene * in_scene;
  return {way / distance, distance, color / fading};
}

}  // namespace pyrasim
