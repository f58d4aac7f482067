// SPDX-License-Identifier: Apache-2.0
#include "texture/mesh_place.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "numeric/vectors.h"

namespace pyrasim {

/// With the triangle about its first vertex, and lengths in units of its size: nothing overflows.
std::optional<MeshPlace> place_along(const TriangleMesh& mesh, std::size_t triangle, const glm::dvec3& origin,
                                     const glm::dvec3& direction) {
  const auto& [i, j, k] = mesh.triangles[triangle];
  const glm::dvec3& a = mesh.vertices[i];
  const glm::dvec3 ab = mesh.vertices[j] - a;
  const glm::dvec3 ac = mesh.vertices[k] - a;
  const double size = std::max(largest(ab), largest(ac));
  const glm::dvec3 side = ab / size;
  const glm::dvec3 other = ac / size;
  const glm::dvec3 normal = glm::cross(side, other);
  const double t = glm::dot(normal, a - origin) / glm::dot(normal, direction);
  if (!(t > 0) || !std::isfinite(t)) return std::nullopt;
  const glm::dvec3 from_a = (origin - a + direction * t) / size;
  const double twice_area = glm::dot(normal, normal);
  const double v = glm::dot(glm::cross(from_a, other), normal) / twice_area;
  const double w = glm::dot(glm::cross(side, from_a), normal) / twice_area;
  const auto [at_a, at_b, at_c] = mesh.places.of(triangle);
  return MeshPlace{at_a + (at_b - at_a) * v + (at_c - at_a) * w, t};
}

}  // namespace pyrasim
