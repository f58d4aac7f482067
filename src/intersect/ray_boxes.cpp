// SPDX-License-Identifier: Apache-2.0
#include "intersect/ray_boxes.h"

#include <algorithm>
#include <cmath>

#include "numeric/vectors.h"

namespace pyrasim {
namespace {

constexpr double longest_squared = 3;

}  // namespace

RayBoxes::RayBoxes(const PreparedScene<double>& scene, const NumberFormat& format)
    : margin_(format, longest_squared, scene.rounding), nodes_(scene.nodes.size()) {
  add(scene, scene.root);
}

/// Fills in the boxes below `reference` and returns what holds all of them.
BoundingBox RayBoxes::add(const PreparedScene<double>& scene, std::int32_t reference) {
  BoundingBox all;
  if (reference >= 0) {
    const auto index = static_cast<std::size_t>(reference);
    for (std::size_t k = 0; k < scene.nodes[index].children; ++k) {
      const BoundingBox child = add(scene, scene.nodes[index].child[k]);
      nodes_[index][k] = child;
      all.include(child);
    }
    return all;
  }
  const SurfaceRun* run = first_run(scene.runs, reference);
  do {
    with_kind(run->kind, [&](auto kind) {
      for (std::uint32_t k = run->first; k < run->first + run->count; ++k) {
        const auto& surface = std::get<kind>(scene.kinds).surfaces[k];
        const auto box = bounds(surface);
        if (!box) continue;  // it stands apart, and no box is asked for it
        const double margin = 2 * margin_.of(surface);
        if constexpr (requires { has_generators(surface); }) generators_ = generators_ || has_generators(surface);
        all.include(BoundingBox{box->lower - margin, box->upper + margin});
      }
    });
  } while (run++->more);
  return all;
}

/// The slab test (Kay, Kajiya 1986): per axis the t at which the ray passes two planes; a quotient errs by 3 roundings
/// of double, which the last comparison grants (Ize, Robust BVH Ray Traversal, JCGT 2013). A ray along the planes is
/// between them or never.
unsigned RayBoxes::met(std::size_t node, const GeneralRay& ray) const {
  constexpr double granted = 1 + 8 * 0x1p-53;
  const double away = largest(ray.origin);
  const double margin = 2 * margin_.of(away) + (generators_ ? margin_.along_generators(away) : 0);
  unsigned met = 0;
  for (std::size_t k = 0; k < node_width; ++k) {
    const auto& [lower, upper] = nodes_[node][k];
    if (!(lower.x <= upper.x)) continue;
    double enter = 0;
    double leave = ray.limit;
    for (int axis = 0; axis < 3; ++axis) {
      const double first = lower[axis] - margin - ray.origin[axis];
      const double last = upper[axis] + margin - ray.origin[axis];
      if (ray.direction[axis] == 0) {
        if (first > 0 || last < 0) leave = -1;
        continue;
      }
      const double a = first / ray.direction[axis];
      const double b = last / ray.direction[axis];
      const double near = b < a ? b : a;
      const double far = b < a ? a : b;
      if (near > enter) enter = near;
      if (far < leave) leave = far;
    }
    if (enter <= leave * granted) met |= 1U << k;
  }
  return met;
}

}  // namespace pyrasim
