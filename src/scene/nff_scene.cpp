// SPDX-License-Identifier: Apache-2.0
#include "scene/nff_scene.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "error.h"
#include "json/json_file.h"
#include "mesh/degenerate.h"
#include "mesh/triangulate.h"
#include "numeric/vectors.h"
#include "scene/nff_words.h"
#include "text/counted.h"
#include "text/printable.h"

namespace pyrasim {
namespace {

constexpr std::string_view coordinate = "coordinate";
constexpr std::string_view component = "component of a colour";
constexpr NumberRange shares{0, 1};
constexpr NumberRange any_number;

/// The triangles of any polygon, without those that have no area.
Mesh cut_up(const std::vector<glm::dvec3>& corners, const Triangulation& triangulation) {
  Mesh mesh;
  mesh.vertices = corners;
  for (const auto& triangle : triangulation.triangles) {
    const auto& [a, b, c] = triangle;
    if (!is_degenerate(corners[a], corners[b], corners[c])) mesh.triangles.push_back(triangle);
  }
  return mesh;
}

class NffReader {
 public:
  NffReader(std::string_view text, const std::string& file) : file_(file), words_(text, file) {}

  Scene read() {
    while (words_.next_command()) {
      const auto* const command = std::find_if(std::begin(commands), std::end(commands),
                                               [&](const Command& its) { return its.name == words_.command(); });
      if (command == std::end(commands)) fail_command();
      (this->*command->read)();
    }
    if (scene_.camera.screen.columns == 0) throw InputError(file_ + ": it has no view; the command v is needed");
    add_lights();
    add_warnings();
    return std::move(scene_);
  }

 private:
  struct Command {
    std::string_view name;
    void (NffReader::*read)();
  };
  static const Command commands[8];

  struct PlacedLight {
    glm::dvec3 position;
    std::optional<glm::dvec3> color;
  };

  [[noreturn]] void fail_command() const {
    std::vector<std::string_view> names;
    for (const Command& command : commands) names.push_back(command.name);
    words_.fail(fmt::format("\"{}\" is no command of NFF", excerpt(words_.command())),
                fmt::format("{} are allowed", fmt::join(names, ", ")));
  }

  void read_view() {
    if (scene_.camera.screen.columns != 0) words_.fail("it is the second view", "one is allowed");
    Camera& camera = scene_.camera;
    camera.position = read_vector("from");
    camera.look_at = read_vector("at");
    camera.up = read_vector("up");
    check(camera);
    expect("angle");
    const double angle = words_.number("angle", {0, 180, true});
    expect("hither");
    static_cast<void>(words_.number("distance", any_number));
    expect("resolution");
    read_screen(width_at_angle(angle));
  }

  void expect(std::string_view name) { words_.expect(name, "from, at, up, angle, hither, resolution is the order"); }

  glm::dvec3 read_vector(std::string_view name) {
    expect(name);
    return words_.vec3(coordinate, coordinates);
  }

  void check(const Camera& camera) const {
    if (!has_direction(camera)) words_.fail("at is the same point as from", "two different points are needed");
    if (largest(camera.up) < min_length || !has_up(camera)) {
      words_.fail("up is zero or parallel to the viewing direction", "any other direction is allowed");
    }
  }

  /// The picture is a square, whatever its pixels are; `side` is its length at distance 1.
  void read_screen(double side) {
    constexpr IntegerRange sizes{1, max_screen_size};
    Screen& screen = scene_.camera.screen;
    screen.columns = static_cast<int>(words_.integer("number of columns", sizes));
    screen.rows = static_cast<int>(words_.integer("number of rows", sizes));
    screen.dx = 1;
    screen.dy = side / screen.rows;
    screen.dz = side / screen.columns;
    if (std::min(screen.dy, screen.dz) < min_length) {
      words_.fail("the angle is too small", fmt::format("pixels of at least {} are needed", min_length));
    }
  }

  void read_background() { scene_.background = words_.vec3(component, color_components); }

  void read_light() {
    PlacedLight light{words_.vec3(coordinate, coordinates), {}};
    if (words_.line_goes_on()) light.color = words_.vec3(component, color_components);
    if (lights_.size() == max_shadow_lights) {
      words_.fail("there are too many lights", fmt::format("at most {} are allowed", max_shadow_lights));
    }
    lights_.push_back(light);
  }

  void read_material() {
    const glm::dvec3 color = words_.vec3(component, color_components);
    color_ = color * words_.number("share (Kd)", shares);
    for (const char* name : {"share (Ks)", "exponent (Shine)"}) static_cast<void>(words_.number(name, any_number));
    if (words_.number("share (T)", any_number) > 0) ++transparent_;
    static_cast<void>(words_.number("index of refraction", any_number));
    ++materials_;
  }

  void read_sphere() {
    const glm::dvec3 center = words_.vec3(coordinate, coordinates);
    add(Sphere{center, words_.number("radius", lengths)});
  }

  void read_cone() {
    AxisSegment axis{};
    axis.base = words_.vec3(coordinate, coordinates);
    const double base_radius = read_cone_radius();
    axis.cap = words_.vec3(coordinate, coordinates);
    const double cap_radius = read_cone_radius();
    if (!(axis.length() >= min_length)) {
      words_.fail("the apex is where the base is", fmt::format("a point at least {} away is needed", min_length));
    }
    if (base_radius != cap_radius) {
      add(Cone{axis, base_radius, cap_radius, false});
    } else if (base_radius > 0) {
      add(Cylinder{axis, base_radius, false});
    } else {
      words_.fail("both radii are 0", "one of the two may be 0");
    }
  }

  double read_cone_radius() {
    const double radius = words_.number("radius", {0, max_coordinate});
    if (radius > 0 && radius < min_length) {
      words_.fail(fmt::format("the radius {} is too small", radius),
                  fmt::format("0 or at least {} is allowed", min_length));
    }
    return radius;
  }

  void read_polygon() { read_corners(false); }
  void read_patch() { read_corners(true); }

  void read_corners(bool normals) {
    const std::int64_t count = words_.integer("number of corners", {3, std::numeric_limits<std::int32_t>::max()});
    corners_.clear();
    for (std::int64_t k = 0; k < count; ++k) {
      corners_.push_back(words_.vec3(coordinate, coordinates));
      if (normals) static_cast<void>(words_.vec3("component of a normal", any_number));
    }
    add_polygon();
  }

  void add_polygon() {
    if (corners_.size() == 3 && !is_degenerate(corners_[0], corners_[1], corners_[2])) {
      return add(Triangle{{corners_[0], corners_[1], corners_[2]}});
    }
    if (corners_.size() > 3 && corners_.size() <= Polygon::max_vertices) {
      Polygon polygon{corners_};
      if (!polygon.fault()) return add(std::move(polygon));
    }
    const Triangulation triangulation = triangulate(corners_);
    Mesh mesh = cut_up(corners_, triangulation);
    if (mesh.triangles.empty()) {
      ++without_area_;
      return;
    }
    if (triangulation.crossing && crossing_++ == 0) first_crossing_ = words_.line();
    add(std::move(mesh));
  }

  void add(SceneSurface&& surface) {
    if (materials_ == 0) {
      words_.fail(fmt::format("\"{}\" has no material", words_.command()), "the command f has to come before it");
    }
    scene_.objects.push_back({"", color_, std::move(surface)});
  }

  /// Lights without a colour share an intensity that does not depend much on how many there are. Without lights
  /// colours are emitted as they are.
  void add_lights() {
    if (lights_.empty()) return;
    const glm::dvec3 white(1 / std::sqrt(static_cast<double>(lights_.size())));
    scene_.lights.emplace();
    for (const auto& [position, color] : lights_) scene_.lights->push_back(PointLight{position, color.value_or(white)});
  }

  void add_warnings() {
    if (transparent_ > 0) {
      warn(fmt::format(
          "{} of {} {} opaque here", transparent_, counted(materials_, "material"),
          of_number(transparent_, "transmits light (T above 0); it is", "transmit light (T above 0); they are")));
    }
    if (without_area_ > 0) {
      warn(fmt::format("{} without an area {} skipped; {} {} left", counted(without_area_, "polygon"),
                       of_number(without_area_, "was", "were"), counted(scene_.objects.size(), "object"),
                       of_number(scene_.objects.size(), "is", "are")));
    }
    if (crossing_ > 0) {
      warn(crossing_warning(crossing_, first_crossing_));
    }
  }

  void warn(const std::string& warning) { scene_.warnings.push_back(file_ + ": " + warning); }

  const std::string& file_;
  NffWords words_;
  Scene scene_;
  std::vector<PlacedLight> lights_;
  glm::dvec3 color_{0};              ///< of the last material
  std::vector<glm::dvec3> corners_;  ///< of a polygon
  std::size_t materials_ = 0;
  std::size_t transparent_ = 0;  ///< materials
  std::size_t without_area_ = 0;
  std::size_t crossing_ = 0;
  std::size_t first_crossing_ = 0;  ///< its last line
};

constexpr NffReader::Command NffReader::commands[8] = {
    {"v", &NffReader::read_view},     {"b", &NffReader::read_background}, {"l", &NffReader::read_light},
    {"f", &NffReader::read_material}, {"s", &NffReader::read_sphere},     {"c", &NffReader::read_cone},
    {"p", &NffReader::read_polygon},  {"pp", &NffReader::read_patch}};

std::string read_text_of(const std::filesystem::path& file, const std::string& name) {
  try {
    return read_text(file);
  } catch (const std::runtime_error& error) {
    throw InputError(fmt::format("{}: cannot be read: {}; a readable NFF file is allowed", name, error.what()));
  }
}

}  // namespace

bool is_nff(const std::filesystem::path& file) { return file.extension() == ".nff"; }

Scene load_nff(const std::filesystem::path& file) {
  const std::string name = one_line(file.string());
  Scene scene = read_nff(read_text_of(file, name), name);
  scene.files.push_back(file.string());
  return scene;
}

Scene read_nff(std::string_view text, const std::string& name) { return NffReader(text, name).read(); }

}  // namespace pyrasim
