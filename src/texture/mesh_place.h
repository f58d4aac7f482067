// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "mesh/triangle_mesh.h"

namespace pyrasim {

/// Where a ray meets the plane of a triangle.
struct MeshPlace {
  glm::dvec2 at;  ///< its texture coordinates, which go on beyond the triangle as they do within it
  double t;
};

/// Of the ray from `origin` along `direction`, in the mesh's coordinates; nothing where it does not meet the plane. All
/// triangles must have texture coordinates.
std::optional<MeshPlace> place_along(const TriangleMesh& mesh, std::size_t triangle, const glm::dvec3& origin,
                                     const glm::dvec3& direction);

}  // namespace pyrasim
