// SPDX-License-Identifier: Apache-2.0
#include "scene/pov_export.h"

#include <fmt/format.h>

#include "camera/observer_frame.h"
#include "surface/pov_writer.h"
#include "text/printable.h"

namespace pyrasim {
namespace {

/// So far away is what shines from a direction. Without shadows it does not matter how far.
constexpr double far_away = 1e6;

/// The screen as three vectors, which say size and handedness.
void write_camera(PovWriter& pov, const Camera& camera) {
  const ObserverFrame frame(camera);
  const Screen& screen = camera.screen;
  pov.object("camera", "perspective location", frame.position(), "direction", frame.forward() * screen.dx, "up",
             frame.up() * (screen.dy * screen.rows), "right", frame.right() * (screen.dz * screen.columns));
  pov.new_line();
}

/// Lambert's cosine law, ambient + (1 - ambient) cosine, on the side that is seen. All surfaces reflect all that
/// arrives; what the ambient light adds is theirs.
void write_light(PovWriter& pov, const std::optional<Light>& light) {
  pov.begin("#default");
  pov.object("finish", "ambient", light ? light->ambient : 1, "diffuse", light ? 1 : 0);
  pov.end();
  pov.new_line();
  if (!light) return;
  pov.object("light_source", normalized(light->direction) * -far_away, "rgb", 1 - light->ambient, "parallel point_at",
             glm::dvec3(0), "shadowless");
  pov.new_line();
}

void write_object(PovWriter& pov, std::size_t number, const Object& object, const glm::dvec3& color) {
  pov.comment(object.name.empty() ? fmt::format("object {}", number)
                                  : fmt::format("object {}: {}", number, one_line(object.name)));
  pov.begin("object");
  std::visit([&](const auto& surface) { surface.write_pov(pov); }, object.surface);
  pov.object("pigment", "rgb", color);
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
  write_light(pov, ids ? std::nullopt : scene.light);
  for (std::size_t k = 0; k < scene.objects.size(); ++k) {
    write_object(pov, k, scene.objects[k], ids ? id_color(k) : scene.objects[k].color);
  }
  return pov.text();
}

}  // namespace pyrasim
