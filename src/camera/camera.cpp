// SPDX-License-Identifier: Apache-2.0
#include "camera/camera.h"

#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "numeric/length_range.h"
#include "numeric/vectors.h"

namespace pyrasim {
namespace {

/// The smallest angle between the viewing direction and `up`, radians.
constexpr double min_up_angle = 1e-9;

}  // namespace

Screen resized(const Screen& screen, int columns, int rows) {
  assert(columns >= 1 && columns <= max_screen_size && rows >= 1 && rows <= max_screen_size);
  const double scale = static_cast<double>(screen.columns) / columns;
  return {columns, rows, screen.dx, screen.dy * scale, screen.dz * scale};
}

double width_at_angle(double degrees) { return 2 * std::tan(degrees / 2 * std::numbers::pi / 180); }

bool has_direction(const Camera& camera) { return largest(camera.look_at - camera.position) >= min_length; }

bool has_up(const Camera& camera) {
  const glm::dvec3 view = camera.look_at - camera.position;
  const glm::dvec3 forward = glm::normalize(view / largest(view));
  const glm::dvec3 up = glm::normalize(camera.up / largest(camera.up));
  return glm::length(glm::cross(forward, up)) >= min_up_angle;
}

}  // namespace pyrasim
