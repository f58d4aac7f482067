// SPDX-License-Identifier: Apache-2.0
#include "scene/load_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <utility>

#include "error.h"
#include "json/json_file.h"
#include "json/json_reader.h"
#include "scene/degenerate.h"
#include "scene/load_mesh.h"

namespace pyrasim {
namespace {

/// The smallest length that is told from zero, world units: its square is far from the smallest double.
constexpr double min_length = 1e-30;
/// The smallest angle between the viewing direction and `up`, radians.
constexpr double min_up_angle = 1e-9;

constexpr NumberRange coordinates{-max_coordinate, max_coordinate};
constexpr NumberRange lengths{min_length, max_coordinate};
constexpr NumberRange color_components{0, max_color};

double largest_component(const glm::dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// A vector whose length does not matter, as long as there is one.
glm::dvec3 read_direction(const JsonReader& reader) {
  const glm::dvec3 direction = reader.vec3(coordinates);
  if (largest_component(direction) < min_length) {
    reader.fail("the vector is zero", fmt::format("a component of at least {} in magnitude is needed", min_length));
  }
  return direction;
}

/// dx, dy and dz from the angle between the screen's left and right sides.
void apply_field_of_view(const JsonReader& reader, Screen& screen) {
  const double degrees = reader.number({0, 180, true});
  screen.dx = 1;
  screen.dz = 2 * std::tan(degrees / 2 * std::numbers::pi / 180) / screen.columns;
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
  const glm::dvec3 view = camera.look_at - camera.position;
  const double distance = largest_component(view);
  if (distance < min_length) {
    reader.fail("look_at is the same point as position", "two different points are needed");
  }
  const glm::dvec3 forward = glm::normalize(view / distance);
  const glm::dvec3 up = glm::normalize(camera.up / largest_component(camera.up));
  if (glm::length(glm::cross(forward, up)) < min_up_angle) {
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

Light read_light(const JsonReader& reader) {
  reader.allow_keys({"ambient", "direction"});
  Light light;
  light.ambient = reader.optional_number("ambient", {0, 1}).value_or(light.ambient);
  light.direction = read_direction(reader.member("direction"));
  return light;
}

Triangle read_triangle(const JsonReader& reader) {
  const JsonReader vertices = reader.member("vertices");
  const auto elements = vertices.elements(3, 3);
  Triangle triangle{};
  std::transform(elements.begin(), elements.end(), triangle.vertices.begin(),
                 [](const JsonReader& vertex) { return vertex.vec3(coordinates); });
  const auto& [a, b, c] = triangle.vertices;
  if (is_degenerate(a, b, c)) vertices.fail("the triangle has no area", "three points not on one line are needed");
  return triangle;
}

/// What the objects of one scene are read with.
struct Context {
  std::filesystem::path folder;  ///< where the paths of meshes begin
  std::vector<std::string>& warnings;
  std::vector<std::string>& files;
};

Mesh read_mesh(const JsonReader& reader, const Context& context) {
  const JsonReader file = reader.member("file");
  const std::string name = file.string();
  if (name.empty() || name.find('\0') != std::string::npos) {
    file.fail("the path is empty or holds a null character", "the path of an OBJ file is allowed");
  }
  try {
    LoadedMesh loaded = load_mesh(context.folder / name);
    context.files.push_back((context.folder / name).string());
    for (const std::string& warning : loaded.warnings) {
      context.warnings.push_back(fmt::format("{}: {}: {}", file.file(), file.pointer(), warning));
    }
    return std::move(loaded.mesh);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}: {}", file.file(), file.pointer(), error.what()));
  }
}

enum class Kind { sphere, plane, triangle, mesh };

Surface read_surface(const JsonReader& reader, Kind kind, const Context& context) {
  switch (kind) {
    case Kind::sphere:
      reader.allow_keys({"name", "type", "color", "center", "radius"});
      return Sphere{reader.member("center").vec3(coordinates), reader.member("radius").number(lengths)};
    case Kind::plane:
      reader.allow_keys({"name", "type", "color", "normal", "offset"});
      return Plane{read_direction(reader.member("normal")), reader.member("offset").number(coordinates)};
    case Kind::triangle:
      reader.allow_keys({"name", "type", "color", "vertices"});
      return read_triangle(reader);
    case Kind::mesh:
      break;
  }
  reader.allow_keys({"name", "type", "color", "file"});
  return read_mesh(reader, context);
}

Object read_object(const JsonReader& reader, const Context& context) {
  const Kind kind = reader.member("type").choice<Kind>(
      {{"sphere", Kind::sphere}, {"plane", Kind::plane}, {"triangle", Kind::triangle}, {"mesh", Kind::mesh}});
  Surface surface = read_surface(reader, kind, context);
  return {reader.optional_string("name").value_or(""), reader.member("color").vec3(color_components),
          std::move(surface)};
}

/// Where the meshes of the scene in `file` are looked for. The folders of open files hold nothing else.
std::filesystem::path folder_of_meshes(const std::filesystem::path& file) {
  const std::filesystem::path folder = file.parent_path();
  const std::string name = folder.string();
  const bool open_files = name == "/dev" || name == "/dev/fd" || (name.starts_with("/proc/") && name.ends_with("/fd"));
  return open_files ? std::filesystem::path() : folder;
}

}  // namespace

Scene load_scene(const std::filesystem::path& file) { return read_scene(file, read_json_file(file)); }

Scene read_scene(const std::filesystem::path& file, const nlohmann::json& document) {
  const JsonReader root(file.string(), document);
  root.allow_keys({"camera", "background", "light", "objects"});
  Scene scene;
  scene.camera = read_camera(root.member("camera"));
  scene.background = root.optional_vec3("background", color_components).value_or(scene.background);
  if (const auto light = root.find("light")) scene.light = read_light(*light);
  scene.files.push_back(file.string());
  const Context context{folder_of_meshes(file), scene.warnings, scene.files};
  for (const JsonReader& reader : root.member("objects").elements()) {
    scene.objects.push_back(read_object(reader, context));
  }
  return scene;
}

}  // namespace pyrasim
