// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "mesh/triangle_mesh.h"
#include "surface/triangle.h"

namespace pyrasim {

/// A whole mesh is one object (decision D4). The datapath holds its triangles.
struct Mesh : TriangleMesh {
  static constexpr std::string_view type = "mesh";
  static constexpr std::array<std::string_view, 1> keys{"file"};

  static Mesh read(const JsonReader& reader, const SceneReading& reading);
  /// Triangles that rounding leaves without an area are left out.
  Mesh transformed(const AffineMap& map) const;
  void write_pov(PovWriter& pov) const;

  /// Calls add(prepared triangle) for each, in the order of the file.
  template <class Add>
  void prepare(const Preparation& preparation, const Add& add) const {
    std::vector<glm::dvec3> observed;
    observed.reserve(vertices.size());
    for (const glm::dvec3& vertex : vertices) observed.push_back(preparation.frame.point(vertex));
    for (const auto& [a, b, c] : triangles) {
      add(prepared_triangle(observed[a], observed[b], observed[c], preparation.lighting));
    }
  }
};

}  // namespace pyrasim
