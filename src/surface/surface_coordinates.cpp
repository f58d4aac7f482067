// SPDX-License-Identifier: Apache-2.0
#include "surface/surface_coordinates.h"

#include <cmath>
#include <numbers>

#include "camera/observer_frame.h"
#include "numeric/scalar.h"

namespace pyrasim {
namespace {

/// Two axes of length 1 across a direction.
struct Across {
  glm::dvec3 u, v;

  explicit Across(const glm::dvec3& direction) {
    const glm::dvec3 normal = normalized(direction);
    constexpr double level = 1e-9;
    if (std::abs(normal.x) < level && std::abs(normal.z) < level) {
      u = {1, 0, 0};
      v = {0, 0, 1};
      return;
    }
    u = normalized(cross(glm::dvec3(0, 1, 0), normal));
    v = cross(normal, u);
  }
};

double turns(double sine, double cosine) { return std::atan2(sine, cosine) / (2 * std::numbers::pi); }

}  // namespace

SurfaceCoordinates on_plane(const glm::dvec3& normal, const glm::dvec3& origin, const glm::dvec3& point) {
  const Across axes(normal);
  const glm::dvec3 from = point - origin;
  return {.u = dot(axes.u, from), .v = dot(axes.v, from)};
}

SurfaceCoordinates about_axis(const glm::dvec3& axis, const glm::dvec3& base, const glm::dvec3& point) {
  const glm::dvec3 along = normalized(axis);
  const glm::dvec3 cosine_axis = Across(axis).u;
  const glm::dvec3 from = point - base;
  return {
      .u = turns(dot(cross(along, cosine_axis), from), dot(cosine_axis, from)), .v = dot(along, from), .u_turns = true};
}

SurfaceCoordinates on_sphere(const glm::dvec3& point) {
  return {.u = turns(point.z, point.x),
          .v = std::atan2(point.y, std::hypot(point.x, point.z)) / std::numbers::pi,
          .u_turns = true};
}

}  // namespace pyrasim
