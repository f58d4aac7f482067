// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <string_view>
#include <vector>

#include "mesh/triangle_mesh.h"
#include "surface/triangle.h"

namespace pyrasim {

/// A whole mesh is one object (decision D4). The datapath holds its triangles.
struct Mesh : TriangleMesh {
  static constexpr std::string_view type = "mesh";
  static constexpr std::array<std::string_view, 3> keys{"file", "smooth", "split"};

  /// The whole of a file; what it is split into, read_mesh_objects.h reads.
  static Mesh read(const JsonReader& reader, const SceneReading& reading);
  /// `part` of the file that an object is of, which says whether its normals count. Throws InputError.
  static Mesh of(TriangleMesh part, const JsonReader& reader);
  /// Triangles that rounding leaves without an area are left out.
  Mesh transformed(const AffineMap& map) const;
  void write_pov(PovWriter& pov) const;

  /// Calls add(prepared triangle) for each, in the order of the file.
  template <class Add>
  void prepare(const Preparation& preparation, const Add& add) const {
    std::vector<glm::dvec3> observed;
    observed.reserve(vertices.size());
    for (const glm::dvec3& vertex : vertices) observed.push_back(preparation.frame.point(vertex));
    for (std::size_t k = 0; k < triangles.size(); ++k) {
      const auto& [a, b, c] = triangles[k];
      auto prepared = prepared_triangle(observed[a], observed[b], observed[c], preparation.lighting);
      if (!normals.empty()) prepared.shading.normals = observed_normals(k, preparation.frame);
      add(prepared);
    }
  }

 private:
  std::shared_ptr<const VertexNormals<double>> observed_normals(std::size_t triangle, const ObserverFrame& frame) const;
};

}  // namespace pyrasim
