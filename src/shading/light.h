// SPDX-License-Identifier: Apache-2.0
// The lights of a scene, as its file says them, in the world's coordinates. An object shows its colour times the sum of
// what they bring.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <variant>
#include <vector>

#include "json/json_reader.h"

namespace pyrasim {

/// The same everywhere.
struct AmbientLight {
  glm::dvec3 color;  ///< linear RGB, intensity included
};

/// From far away: color cos, where cos is that of the angle between the way to the light and the normal on the viewer's
/// side, and 0 where the light is behind.
struct DirectionalLight {
  glm::dvec3 direction;  ///< the way the light travels, any length but zero
  glm::dvec3 color;
  bool shadow = true;  ///< what is between it and a place darkens the place
};

/// How a point light fades with the distance d in the scene's unit: not at all, by 1 / d or by 1 / d^2.
enum class Falloff : std::uint8_t { none, linear, quadratic };

struct PointLight {
  glm::dvec3 position;
  glm::dvec3 color;
  Falloff falloff = Falloff::none;
  bool shadow = true;
};

using Light = std::variant<AmbientLight, DirectionalLight, PointLight>;

/// Lights with shadows that a scene may have: a sample has a bit for each (decision D5).
inline constexpr std::size_t max_shadow_lights = 32;

inline bool casts_shadows(const Light& light) {
  return std::visit(
      [](const auto& its) {
        if constexpr (requires { its.shadow; }) return its.shadow;
        return false;
      },
      light);
}

/// Reads the array "lights". Throws InputError, also where more than max_shadow_lights have shadows.
std::vector<Light> read_lights(const JsonReader& reader);

}  // namespace pyrasim
