// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "intersect/prepared_scene.h"

namespace pyrasim::silhouettes {

/// A triangle, or one of an instance's, which the datapath meets in the mesh's coordinates.
struct Facet {
  /// Between which slopes it is seen, to a few roundings of double.
  struct Extent {
    float lower_y, upper_y, lower_z, upper_z;
  };

  TriangleSurface<double> triangle;  ///< as the mesh has it
  const InstanceSurface<double>* instance = nullptr;
  std::uint32_t place = 0;  ///< in the instance's mesh
  Extent extent{};
  float doubt = 0;  ///< of its slopes, in roundings
};

/// A scene whose numbers are taken as exact: prepared for a datapath in double, where nothing is rounded any more. The
/// observer is outside of all spheres and before all triangles, and the screen's slopes are at most 1.
class ExactScene {
 public:
  explicit ExactScene(const Scene& scene);

  template <std::size_t kind>
  const auto& surfaces() const {
    return std::get<kind>(prepared_.kinds).surfaces;
  }
  /// The scene's triangles, in their order, then those of instances.
  const std::vector<Facet>& facets() const { return facets_; }
  const PreparedScene<double>& prepared() const { return prepared_; }

  /// The largest of the observer's coordinates in the world.
  double place() const { return prepared_.rounding.place; }

  /// The smallest depth of a facet's vertex.
  double nearest_vertex() const { return nearest_vertex_; }

  /// The facet of the same object on the other side of an edge. Edges that more than two share count as borders.
  struct Neighbor {
    std::int32_t facet = -1;  ///< none: the edge is a border
    bool turned = false;      ///< its vertices go round the other way
  };
  /// Edge k lies opposite vertex k.
  const Neighbor& neighbor(std::size_t facet, std::size_t edge) const { return neighbors_[facet][edge]; }

  /// By what power of two lengths are larger in a datapath of `format`.
  static int exponent_of(const NumberFormat& format);

 private:
  void find_facets();
  void find_extent(Facet& facet);
  void find_neighbors();

  PreparedScene<double> prepared_;
  std::vector<Facet> facets_;
  double nearest_vertex_ = std::numeric_limits<double>::infinity();
  std::vector<std::array<Neighbor, 3>> neighbors_;
};

}  // namespace pyrasim::silhouettes
