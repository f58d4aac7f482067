// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace pyrasim {

struct TriangleMesh {
  std::vector<glm::dvec3> vertices;                     ///< world units
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< indices into vertices; none is degenerate
};

}  // namespace pyrasim
