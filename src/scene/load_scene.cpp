// SPDX-License-Identifier: Apache-2.0
#include "scene/load_scene.h"

#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "json/json_file.h"
#include "json/json_reader.h"
#include "scene/nff_scene.h"
#include "scene/read_objects.h"
#include "surface/reading.h"

namespace pyrasim {
namespace {

/// dx, dy and dz from the angle between the screen's left and right sides.
void apply_field_of_view(const JsonReader& reader, Screen& screen) {
  const double degrees = reader.number({0, 180, true});
  screen.dx = 1;
  screen.dz = width_at_angle(degrees) / screen.columns;
  screen.dy = screen.dz;
  if (screen.dz < min_length) reader.fail("the angle is too small", "pixels of at least 1e-30 are needed");
}

Screen read_screen(const JsonReader& reader) {
  reader.allow_keys({"columns", "rows", "dx", "dy", "dz", "horizontal_fov"});
  constexpr IntegerRange sizes{1, max_screen_size};
  Screen screen;
  screen.columns = static_cast<int>(reader.member("columns").integer(sizes));
  screen.rows = static_cast<int>(reader.member("rows").integer(sizes));
  if (const auto field_of_view = reader.find("horizontal_fov")) {
    for (const char* key : {"dx", "dy", "dz"}) {
      if (const auto given = reader.find(key)) {
        given->fail("it is given beside horizontal_fov", "either horizontal_fov or dx, dy and dz is allowed");
      }
    }
    apply_field_of_view(*field_of_view, screen);
    return screen;
  }
  if (!reader.has("dx") && !reader.has("dy") && !reader.has("dz")) {
    reader.fail("the size of the pixels is missing", "either horizontal_fov or dx, dy and dz must be given");
  }
  screen.dx = reader.member("dx").number(lengths);
  screen.dy = reader.member("dy").number(lengths);
  screen.dz = reader.member("dz").number(lengths);
  return screen;
}

/// Fails unless the camera's three members span a frame.
void check_camera(const JsonReader& reader, const Camera& camera) {
  if (!has_direction(camera)) reader.fail("look_at is the same point as position", "two different points are needed");
  if (!has_up(camera)) {
    reader.fail("up is parallel to the viewing direction", "an angle between them other than 0 and 180 is needed");
  }
}

Camera read_camera(const JsonReader& reader) {
  reader.allow_keys({"position", "look_at", "up", "screen"});
  Camera camera;
  camera.position = reader.optional_vec3("position", coordinates).value_or(camera.position);
  camera.look_at = reader.optional_vec3("look_at", coordinates).value_or(camera.look_at);
  if (const auto up = reader.find("up")) camera.up = read_direction(*up);
  camera.screen = read_screen(reader.member("screen"));
  check_camera(reader, camera);
  return camera;
}

SingleLight read_light(const JsonReader& reader) {
  reader.allow_keys({"ambient", "direction"});
  SingleLight light;
  light.ambient = reader.optional_number("ambient", {0, 1}).value_or(light.ambient);
  light.direction = read_direction(reader.member("direction"));
  return light;
}

/// Where the meshes of the scene in `file` are looked for. The folders of open files hold nothing else.
std::filesystem::path folder_of_meshes(const std::filesystem::path& file) {
  const std::filesystem::path folder = file.parent_path();
  const std::string name = folder.string();
  const bool open_files = name == "/dev" || name == "/dev/fd" || (name.starts_with("/proc/") && name.ends_with("/fd"));
  return open_files ? std::filesystem::path() : folder;
}

}  // namespace

Scene load_scene(const std::filesystem::path& file) {
  return is_nff(file) ? load_nff(file) : read_scene(file, read_json_file(file));
}

Scene read_scene(const std::filesystem::path& file, const nlohmann::json& document) {
  const JsonReader root(file.string(), document);
  root.allow_keys({"camera", "background", "light", "lights", "shapes", "objects"});
  Scene scene;
  scene.camera = read_camera(root.member("camera"));
  scene.background = root.optional_vec3("background", color_components).value_or(scene.background);
  if (const auto light = root.find("light")) scene.light = read_light(*light);
  if (const auto lights = root.find("lights")) {
    if (scene.light) lights->fail("it is given beside light", "either light or lights is allowed");
    scene.lights = read_lights(*lights);
  }
  scene.files.push_back(file.string());
  std::map<std::string, LoadedMesh> meshes;
  scene.objects = read_objects(root, {folder_of_meshes(file), scene.warnings, scene.files, meshes});
  return scene;
}

}  // namespace pyrasim
