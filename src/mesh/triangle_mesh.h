// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace pyrasim {

/// By the corners of a triangle: indices into a list.
using TriangleCorners = std::array<std::uint32_t, 3>;

/// Values that triangles have at their corners, and share.
template <class Value>
struct CornerValues {
  std::vector<Value> values;
  std::vector<TriangleCorners> corners;  ///< by triangle; empty where the mesh has no such values

  bool empty() const { return corners.empty(); }
  std::array<Value, 3> of(std::size_t triangle) const {
    const auto& [a, b, c] = corners[triangle];
    return {values[a], values[b], values[c]};
  }
};

/// Of a corner that has no value.
inline constexpr std::uint32_t no_value = 0xFFFFFFFF;

/// Whether all triangles have values at all of their corners.
template <class Value>
bool all_have(const CornerValues<Value>& values) {
  const auto has = [](const TriangleCorners& corners) {
    return std::find(corners.begin(), corners.end(), no_value) == corners.end();
  };
  return !values.empty() && std::all_of(values.corners.begin(), values.corners.end(), has);
}

struct TriangleMesh {
  std::vector<glm::dvec3> vertices;        ///< world units
  std::vector<TriangleCorners> triangles;  ///< none is degenerate
  CornerValues<glm::dvec2> places;         ///< on a texture, u to the right and v upwards
  CornerValues<glm::dvec3> normals;        ///< of the surface that the triangles stand for

  /// Leaves out the triangles that `out(a, b, c)` says so of, given their vertices.
  template <class Out>
  void erase_triangles(const Out& out) {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < triangles.size(); ++k) {
      const auto [a, b, c] = triangles[k];
      if (out(vertices[a], vertices[b], vertices[c])) continue;
      triangles[kept] = triangles[k];
      if (!places.empty()) places.corners[kept] = places.corners[k];
      if (!normals.empty()) normals.corners[kept] = normals.corners[k];
      ++kept;
    }
    triangles.resize(kept);
    if (!places.empty()) places.corners.resize(kept);
    if (!normals.empty()) normals.corners.resize(kept);
  }
};

}  // namespace pyrasim
