// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "scene/scene.h"
#include "trace/surface.h"

namespace pyrasim {

/// Children of an inner node of the hierarchy at most.
inline constexpr std::size_t node_width = 4;

/// A scene made ready for a datapath of one number format: in observer's coordinates, rounded once to `Scalar`, with a
/// bounding volume hierarchy over its bounded surfaces. Planes have no bounds and stand apart.
template <class Scalar>
struct PreparedScene {
  /// An inner node: the boxes of its two to four children side by side, so that one visit tests all. The boxes of
  /// children that it does not have are inside out and never hit.
  struct alignas(64) Node {
    std::array<std::array<std::array<Scalar, node_width>, 2>, 3> bounds;  ///< [axis][0 lower, 1 upper][child]
    std::array<std::int32_t, node_width> child;                           ///< index into nodes, or ~index into leaves
    std::uint32_t children;
  };
  struct Leaf {
    std::uint32_t first_sphere, spheres, first_triangle, triangles;
  };

  std::vector<Node> nodes;
  std::vector<Leaf> leaves;
  std::int32_t root = 0;  ///< as Node::child; meaningful where there are leaves
  std::vector<SphereSurface<Scalar>> spheres;
  std::vector<TriangleSurface<Scalar>> triangles;
  std::vector<FlatShading<Scalar>> triangle_shading;  ///< one for each triangle
  std::vector<PlaneSurface<Scalar>> planes;
  bool lit = false;  ///< without a light, colours are emitted as they are
  Scalar ambient{1};
  Vector<Scalar> towards_light{0, 0, 0};  ///< of length 1
};

template <class Scalar>
PreparedScene<Scalar> prepare_scene(const Scene& scene);

extern template PreparedScene<double> prepare_scene<double>(const Scene& scene);
extern template PreparedScene<float> prepare_scene<float>(const Scene& scene);

}  // namespace pyrasim
