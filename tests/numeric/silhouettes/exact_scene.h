// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "intersect/prepared_scene.h"

namespace pyrasim::silhouettes {

/// A scene whose numbers are taken as exact: prepared for a datapath in double, where nothing is rounded any more. The
/// observer is outside of all spheres and before all triangles, and the screen's slopes are at most 1.
class ExactScene {
 public:
  explicit ExactScene(const Scene& scene);

  template <std::size_t kind>
  const auto& surfaces() const {
    return std::get<kind>(prepared_.kinds).surfaces;
  }
  const std::vector<TriangleSurface<double>>& triangles() const { return surfaces_of<TriangleSurface>(prepared_); }

  /// The largest of the observer's coordinates in the world.
  double place() const { return prepared_.rounding.place; }

  /// Between which slopes a triangle is seen, to a few roundings of double.
  struct Extent {
    float lower_y, upper_y, lower_z, upper_z;
  };
  const std::vector<Extent>& extents() const { return extents_; }
  /// The smallest depth of a triangle's vertex.
  double nearest_vertex() const { return nearest_vertex_; }

  /// The triangle of the same object on the other side of an edge. Edges that more than two share count as borders.
  struct Neighbor {
    std::int32_t triangle = -1;  ///< none: the edge is a border
    bool turned = false;         ///< its vertices go round the other way
  };
  /// Edge k lies opposite vertex k.
  const Neighbor& neighbor(std::size_t triangle, std::size_t edge) const { return neighbors_[triangle][edge]; }

  /// By what power of two lengths are larger in a datapath of `format`.
  static int exponent_of(const NumberFormat& format);

 private:
  void find_extents();
  void find_neighbors();

  PreparedScene<double> prepared_;
  std::vector<Extent> extents_;
  double nearest_vertex_ = 0;
  std::vector<std::array<Neighbor, 3>> neighbors_;
};

}  // namespace pyrasim::silhouettes
