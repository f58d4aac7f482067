// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <tuple>
#include <vector>

#include "intersect/hierarchy_builder.h"
#include "numeric/format_scope.h"
#include "scene/scene.h"
#include "surface/bounding_box.h"
#include "surface/lighting.h"
#include "surface/list.h"
#include "surface/rounding_units.h"

namespace pyrasim {

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

/// An inner node of two to four children, the nearest first.
template <class Scalar>
struct alignas(64) WideNode {
  SlopeBoxes<Scalar> boxes;
  std::array<std::int32_t, node_width> child;  ///< index into nodes, or ~index into runs, of a leaf's first
  std::uint32_t children;
};

/// Surfaces of one kind that stand side by side. A leaf is one run, or several that follow each other.
struct SurfaceRun {
  std::uint32_t first;
  std::uint32_t count;
  SurfaceKind kind;
  bool more;              ///< the leaf goes on with the next run
  double relative_error;  ///< the largest of the leaf's surfaces', distance_range.h
};

template <class Scalar>
class Illumination;

/// A scene made ready for a datapath of one number format: in observer's coordinates, multiplied by a power of two that
/// suits the format, and rounded once to `Scalar`; with a bounding volume hierarchy over its bounded surfaces. Those
/// without bounds stand apart.
template <class Scalar>
struct PreparedScene {
  using Node = WideNode<Scalar>;

  std::vector<Node> nodes;
  std::vector<SurfaceRun> runs;
  std::int32_t root = 0;              ///< of the hierarchy, as Node::child
  std::int32_t everything = 0;        ///< likewise, a leaf of all bounded surfaces: for rays that do not run forward
  std::optional<std::int32_t> apart;  ///< likewise, a leaf of the others, if there are any
  SurfaceStore<Scalar> kinds;         ///< of each those apart first, then in the order of leaves
  Lighting<Scalar> lighting;
  const Illumination<Scalar>* illumination = nullptr;              ///< where the scene has a list of lights
  int exponent = 0;                                                ///< lengths are the scene's times 2^exponent
  RoundingUnits rounding;                                          ///< of the format
  ScalarFormat<Scalar> numbers = ScalarFormat<Scalar>::current();  ///< the format, as computing in it takes it
};

/// The surfaces of one kind: surfaces_of<SphereSurface>(scene).
template <template <class> class Surface, class Scalar>
const std::vector<Surface<Scalar>>& surfaces_of(const PreparedScene<Scalar>& scene) {
  return std::get<index_of_kind<Surface>>(scene.kinds).surfaces;
}

/// The first run of the leaf `leaf`, a reference as Node::child; the others follow it.
inline const SurfaceRun* first_run(const std::vector<SurfaceRun>& runs, std::int32_t leaf) {
  return &runs[static_cast<std::size_t>(~static_cast<std::int64_t>(leaf))];
}

/// The scene for a datapath of `format`, not yet rounded to it.
PreparedScene<double> prepare_scene(const Scene& scene, const NumberFormat& format);

}  // namespace pyrasim
