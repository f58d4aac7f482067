// SPDX-License-Identifier: Apache-2.0
#include "scene/pov_export.h"

#include <fmt/format.h>

#include <cmath>

#include "camera/observer_frame.h"
#include "surface/pov_writer.h"
#include "text/printable.h"

namespace pyrasim {
namespace {

/// So far away is what shines from a direction: within what POV-Ray sees, and beyond what is to cast shadows.
constexpr double far_away = 1e6;

/// The screen as three vectors, which say size and handedness.
void write_camera(PovWriter& pov, const Camera& camera) {
  const ObserverFrame frame(camera);
  const Screen& screen = camera.screen;
  pov.object("camera", "perspective location", frame.position(), "direction", frame.forward() * screen.dx, "up",
             frame.up() * (screen.dy * screen.rows), "right", frame.right() * (screen.dz * screen.columns));
  pov.new_line();
}

/// A point light of POV-Ray fades by 2 / (1 + (d / near)^power): where d is far more, by a constant over d^power.
constexpr double near = 1e-6;

int power_of(Falloff falloff) { return falloff == Falloff::none ? 0 : falloff == Falloff::linear ? 1 : 2; }

/// What surfaces reflect and add is said once for all of them; their cosine law, on the side that is seen, is
/// POV-Ray's.
void write_finish(PovWriter& pov, const glm::dvec3& ambient, double diffuse) {
  pov.begin("#default");
  pov.object("finish", "ambient rgb", ambient, "diffuse", diffuse);
  pov.end();
  pov.new_line();
}

void begin_light(PovWriter& pov, const glm::dvec3& place, const glm::dvec3& color, bool shadow) {
  pov.begin("light_source");
  pov.add(place, "rgb", color);
  if (!shadow) pov.add("shadowless");
}

void end_light(PovWriter& pov) {
  pov.end();
  pov.new_line();
}

/// It is in the finish.
void write_light(PovWriter&, const AmbientLight&) {}

void write_light(PovWriter& pov, const DirectionalLight& light) {
  begin_light(pov, normalized(light.direction) * -far_away, light.color, light.shadow);
  pov.add("parallel point_at", glm::dvec3(0));
  end_light(pov);
}

void write_light(PovWriter& pov, const PointLight& light) {
  const int power = power_of(light.falloff);
  begin_light(pov, light.position, power == 0 ? light.color : light.color / (2 * std::pow(near, power)), light.shadow);
  if (power != 0) pov.add("fade_distance", near, "fade_power", power);
  end_light(pov);
}

void write_lights(PovWriter& pov, const std::vector<Light>& lights) {
  glm::dvec3 ambient(0);
  for (const Light& light : lights) {
    if (const auto* its = std::get_if<AmbientLight>(&light)) ambient += its->color;
  }
  write_finish(pov, ambient, 1);
  for (const Light& light : lights) std::visit([&](const auto& its) { write_light(pov, its); }, light);
}

/// The single light as two of a list: ambient + (1 - ambient) cosine.
void write_lights(PovWriter& pov, const Scene& scene) {
  if (scene.lights) return write_lights(pov, *scene.lights);
  if (!scene.light) return write_finish(pov, glm::dvec3(1), 0);
  const auto& [ambient, direction] = *scene.light;
  write_lights(pov, {AmbientLight{glm::dvec3(ambient)}, DirectionalLight{direction, glm::dvec3(1 - ambient), false}});
}

void declare_meshes(PovWriter& pov, const std::vector<Object>& objects) {
  for (const Object& object : objects) {
    if (const auto* instance = std::get_if<MeshInstance>(&object.surface)) instance->declare_pov(pov);
  }
}

void write_object(PovWriter& pov, std::size_t number, const Object& object, const glm::dvec3& color) {
  pov.comment(object.name.empty() ? fmt::format("object {}", number)
                                  : fmt::format("object {}: {}", number, one_line(object.name)));
  pov.begin("object");
  std::visit([&](const auto& surface) { surface.write_pov(pov); }, object.surface);
  pov.object("pigment", "rgb", color);
  if (!object.casts_shadow) pov.add("no_shadow");
  pov.end();
  pov.new_line();
}

}  // namespace

/// The bits of the number above that of the background, 0, dealt out to the components from the highest places down.
glm::dvec3 id_color(std::size_t object) {
  glm::ivec3 levels(0);
  const std::size_t id = object + 1;
  for (int bit = 0; bit < 24; ++bit) {
    if ((id >> static_cast<unsigned>(bit) & 1U) != 0) levels[bit % 3] |= 128 >> (bit / 3);
  }
  return glm::dvec3(levels) / 255.0;
}

std::string pov_scene(const Scene& scene, bool ids, const std::string& remark) {
  const Screen& screen = scene.camera.screen;
  PovWriter pov;
  pov.comment(remark);
  pov.comment(
      fmt::format("povray +W{} +H{} shows all of the screen, in the shape of its pixels", screen.columns, screen.rows));
  pov.add("#version 3.7;");
  pov.new_line();
  pov.object("global_settings", "assumed_gamma", 1);
  pov.new_line();
  write_camera(pov, scene.camera);
  pov.object("background", "rgb", ids ? glm::dvec3(0) : scene.background);
  pov.new_line();
  ids ? write_finish(pov, glm::dvec3(1), 0) : write_lights(pov, scene);
  declare_meshes(pov, scene.objects);
  for (std::size_t k = 0; k < scene.objects.size(); ++k) {
    const Object& object = scene.objects[k];
    const glm::dvec3 color = object.texture ? object.color * object.texture->texture.mean() : object.color;
    write_object(pov, k, object, ids ? id_color(k) : color);
  }
  return pov.text();
}

}  // namespace pyrasim
