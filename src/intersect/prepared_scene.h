// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "intersect/bounding_box.h"
#include "intersect/rounding_units.h"
#include "intersect/surface.h"
#include "numeric/number_format.h"
#include "scene/scene.h"

namespace pyrasim {

/// Children of an inner node of the hierarchy at most.
inline constexpr std::size_t node_width = 4;

/// The boxes of a node's children side by side in slope space (slope_bounds.h), so that one visit tests all. The
/// boxes of children that it does not have are inside out and never met.
template <class Scalar>
struct SlopeBoxes {
  using Bound = std::array<Scalar, node_width>;
  Bound depth;  ///< where the box begins
  Bound lower_y, upper_y, lower_z, upper_z;

  void set(std::size_t k, const BoundingBox& box) {
    depth[k] = box.lower.x;
    lower_y[k] = box.lower.y;
    upper_y[k] = box.upper.y;
    lower_z[k] = box.lower.z;
    upper_z[k] = box.upper.z;
  }
};

/// A scene made ready for a datapath of one number format: in observer's coordinates, multiplied by a power of two that
/// suits the format, and rounded once to `Scalar`; with a bounding volume hierarchy over its bounded surfaces. Planes
/// have no bounds and stand apart.
template <class Scalar>
struct PreparedScene {
  /// An inner node of two to four children, the nearest first.
  struct alignas(64) Node {
    SlopeBoxes<Scalar> boxes;
    std::array<std::int32_t, node_width> child;  ///< index into nodes, or ~index into leaves
    std::uint32_t children;
  };
  struct Leaf {
    std::uint32_t first_sphere, spheres, first_triangle, triangles;
    double relative_error;  ///< the largest of its surfaces', relative_error.h
  };

  std::vector<Node> nodes;
  std::vector<Leaf> leaves;
  std::int32_t root = 0;        ///< as Node::child
  std::int32_t everything = 0;  ///< likewise, a leaf of all bounded surfaces: for rays that do not run forward
  std::vector<SphereSurface<Scalar>> spheres;
  std::vector<TriangleSurface<Scalar>> triangles;
  std::vector<FlatShading<Scalar>> triangle_shading;  ///< one for each triangle
  std::vector<PlaneSurface<Scalar>> planes;
  bool lit = false;  ///< without a light, colours are emitted as they are
  Scalar ambient{1};
  Vector<Scalar> towards_light{0, 0, 0};  ///< of length 1
  int exponent = 0;                       ///< lengths are the scene's times 2^exponent
  RoundingUnits rounding;                 ///< of the format
};

/// The scene for a datapath of `format`, not yet rounded to it.
PreparedScene<double> prepare_scene(const Scene& scene, const NumberFormat& format);

}  // namespace pyrasim
