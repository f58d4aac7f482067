// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "shading/color.h"
#include "shading/light.h"
#include "surface/reading.h"

namespace pyrasim {
namespace {

glm::dvec3 read_color(const JsonReader& reader) {
  const glm::dvec3 color = reader.member("color").vec3(color_components);
  return color * reader.optional_number("intensity", color_components).value_or(1);
}

bool read_shadow(const JsonReader& reader) { return reader.optional_boolean("shadow").value_or(true); }

Light read_ambient(const JsonReader& reader) {
  reader.allow_keys({"type", "color", "intensity"});
  return AmbientLight{read_color(reader)};
}

Light read_directional(const JsonReader& reader) {
  reader.allow_keys({"type", "direction", "color", "intensity", "shadow"});
  return DirectionalLight{read_direction(reader.member("direction")), read_color(reader), read_shadow(reader)};
}

Light read_point(const JsonReader& reader) {
  reader.allow_keys({"type", "position", "color", "intensity", "falloff", "shadow"});
  const auto falloff = reader.optional_choice<Falloff>(
      "falloff", {{"none", Falloff::none}, {"linear", Falloff::linear}, {"quadratic", Falloff::quadratic}});
  return PointLight{reader.member("position").vec3(coordinates), read_color(reader), falloff.value_or(Falloff::none),
                    read_shadow(reader)};
}

}  // namespace

std::vector<Light> read_lights(const JsonReader& reader) {
  using Read = Light (*)(const JsonReader&);
  std::vector<Light> lights;
  std::size_t with_shadows = 0;
  for (const JsonReader& light : reader.elements()) {
    const Read read = light.member("type").choice<Read>(
        {{"ambient", read_ambient}, {"directional", read_directional}, {"point", read_point}});
    lights.push_back(read(light));
    if (!casts_shadows(lights.back())) continue;
    if (++with_shadows > max_shadow_lights) {
      light.fail("there are too many lights with shadows",
                 fmt::format("at most {} are allowed, and any number with \"shadow\": false", max_shadow_lights));
    }
  }
  return lights;
}

}  // namespace pyrasim
