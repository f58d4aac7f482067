// SPDX-License-Identifier: Apache-2.0
// Where a point of a surface lies on it: what textures are laid out by. All in the coordinates that the surface was
// written in, before transforms.
#pragma once

#include <glm/vec3.hpp>

namespace pyrasim {

struct SurfaceCoordinates {
  double u = 0;
  double v = 0;
  int chart = 0;         ///< coordinates of different charts, as a box's faces, have nothing to do with each other
  bool u_turns = false;  ///< u and u + 1 are one place; likewise v
  bool v_turns = false;
};

/// Lengths along two axes of a plane, from `origin`. On a level plane, whose normal is along y, u runs along x and v
/// along z; on any other v runs uphill, against gravity that acts along -y, and u to the right of it, seen from the
/// normal's side.
SurfaceCoordinates on_plane(const glm::dvec3& normal, const glm::dvec3& origin, const glm::dvec3& point);

/// u: the angle about `axis`, in turns from -1/2 to 1/2, right-handed; v: the height along it, from `base` on. The
/// angle is 0 where u of the plane across the axis grows.
SurfaceCoordinates about_axis(const glm::dvec3& axis, const glm::dvec3& base, const glm::dvec3& point);

/// u: longitude in turns, from -1/2 to 1/2, 0 along x and growing towards z; v: latitude in half turns, from -1/2 below
/// to 1/2 above (y). Of a point of the unit sphere.
SurfaceCoordinates on_sphere(const glm::dvec3& point);

}  // namespace pyrasim
