// SPDX-License-Identifier: Apache-2.0
// What a scene file says, in the world's coordinates.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace pyrasim {

/// The screen of formulas (4) and (5). Lengths are in the world's units.
struct Screen {
  int columns = 0;  ///< N_z, pixels
  int rows = 0;     ///< N_y, pixels
  double dx = 1;    ///< from the centre of projection to the screen
  double dy = 0;    ///< height of a pixel
  double dz = 0;    ///< width of a pixel
};

/// The largest number of columns or rows that a screen may have, pixels.
inline constexpr int max_screen_size = 65535;

/// The same view on another number of pixels: N_z dz (the screen's width), dx and the pixel's aspect stay.
Screen resized(const Screen& screen, int columns, int rows);

/// The part of a screen that is rendered, pixels. Its pixels are those of the whole screen, bit for bit.
struct PixelWindow {
  int column = 0;   ///< of the screen, the leftmost in the window
  int row = 0;      ///< of the screen, the uppermost in the window
  int columns = 0;  ///< of the picture
  int rows = 0;
};

/// The observer. The defaults are the observer's own frame: x forward, y up, z right.
struct Camera {
  glm::dvec3 position{0, 0, 0};  ///< centre of projection
  glm::dvec3 look_at{1, 0, 0};
  glm::dvec3 up{0, 1, 0};
  Screen screen;
  std::optional<PixelWindow> window;  ///< within the screen; absent: the whole screen

  PixelWindow rendered() const { return window.value_or(PixelWindow{0, 0, screen.columns, screen.rows}); }
};

/// One directional light, without shadows.
struct Light {
  double ambient = 0;              ///< share of light that arrives from everywhere, 0 to 1
  glm::dvec3 direction{0, -1, 0};  ///< the way the light travels, any length but zero
};

struct Sphere {
  glm::dvec3 center;
  double radius;
};

/// The points p with normal . p = offset. The normal has any length but zero.
struct Plane {
  glm::dvec3 normal;
  double offset;
};

struct Triangle {
  std::array<glm::dvec3, 3> vertices;
};

/// A whole mesh is one object (decision D4).
struct Mesh {
  std::vector<glm::dvec3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< indices into vertices; none is degenerate
};

using Surface = std::variant<Sphere, Plane, Triangle, Mesh>;

/// One entry of the scene: what decides case 2 against case 3 (decision D4).
struct Object {
  std::string name;  ///< may be empty
  glm::dvec3 color;  ///< linear RGB
  Surface surface;
};

/// The largest value of a colour component.
inline constexpr double max_color = 4096;

struct Scene {
  Camera camera;
  glm::dvec3 background{0, 0, 0};  ///< linear RGB
  std::optional<Light> light;      ///< absent: colours are emitted as they are
  std::vector<Object> objects;
  std::vector<std::string> warnings;  ///< one line each, for stderr
  std::vector<std::string> files;     ///< that it was read from: the scene's own, then its meshes'
};

}  // namespace pyrasim
