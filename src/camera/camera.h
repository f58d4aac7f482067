// SPDX-License-Identifier: Apache-2.0
// The observer and his screen, in the world's coordinates.
#pragma once

#include <glm/vec3.hpp>
#include <optional>

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

/// The width at distance 1 that an angle at the centre of projection spans. `degrees` is between 0 and 180.
double width_at_angle(double degrees);

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

/// Whether `position` and `look_at` are two points.
bool has_direction(const Camera& camera);

/// Whether `up`, which is not zero, says which way is up: it is not parallel to the viewing direction.
bool has_up(const Camera& camera);

}  // namespace pyrasim
