// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/degenerate.h"
#include "surface/surface_coordinates.h"
#include "surface/triangle.h"

namespace pyrasim {

/// Flat and convex, seen from both sides. The datapath holds triangles that fan out from the first vertex: they share
/// their edges, so that no ray runs between them.
struct Polygon {
  static constexpr std::string_view type = "polygon";
  static constexpr std::array<std::string_view, 1> keys{"vertices"};

  /// That a scene file may give.
  static constexpr std::size_t max_vertices = 4096;

  struct Fault {
    std::string wrong;
    std::string_view allowed;
  };

  std::vector<glm::dvec3> vertices;  ///< once around

  /// Why its vertices, three or more, are not those of a flat and convex polygon; nothing where they are.
  std::optional<Fault> fault() const;

  static Polygon read(const JsonReader& reader, const SceneReading& reading);
  Polygon transformed(const AffineMap& map) const;
  SurfaceCoordinates coordinates_at(const glm::dvec3& point) const;
  void write_pov(PovWriter& pov) const;

  /// Calls add(prepared triangle) for each.
  template <class Add>
  void prepare(const Preparation& preparation, const Add& add) const {
    const auto observed = [&](std::size_t k) { return preparation.frame.point(vertices[k]); };
    for (std::size_t k = 2; k < vertices.size(); ++k) {
      if (is_degenerate(vertices[0], vertices[k - 1], vertices[k])) continue;  // a vertex on a straight side
      add(prepared_triangle(observed(0), observed(k - 1), observed(k), preparation.lighting));
    }
  }
};

}  // namespace pyrasim
