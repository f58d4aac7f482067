// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <type_traits>

#include "intersect/instanced_triangle.h"

namespace pyrasim {

/// Calls visit(surface, place) for each that a ray may meet of the surfaces of a kind in a run, of instances for each
/// of their triangles. Each has intersect(ViewRay), seen_from and an identity. `place`: among the surfaces of its kind.
template <std::size_t kind, class Scalar, class Visit>
void for_each_met(const PreparedScene<Scalar>& scene, std::uint32_t first, std::uint32_t count, const Visit& visit) {
  const auto& surfaces = std::get<kind>(scene.kinds).surfaces;
  for (std::uint32_t k = first; k < first + count; ++k) {
    if constexpr (kind == index_of_kind<InstanceSurface>) {
      const SharedMesh<Scalar>& mesh = scene.meshes[surfaces[k].mesh];
      for (std::uint32_t place = 0; place < mesh.triangles.size(); ++place) {
        visit(InstancedTriangle<Scalar>(surfaces[k], mesh, place), k);
      }
    } else {
      visit(surfaces[k], k);
    }
  }
}
template <std::size_t kind, class Scalar, class Visit>
void for_each_met(const PreparedScene<Scalar>& scene, const Visit& visit) {
  for_each_met<kind>(scene, 0, static_cast<std::uint32_t>(std::get<kind>(scene.kinds).surfaces.size()), visit);
}

/// Where its exact hit lies.
template <class Scalar, class Surface>
DistanceRange range_of_met(const Surface& surface, const Vector<Scalar>& direction, double t,
                           const RoundingUnits& rounding) {
  if constexpr (std::is_same_v<Surface, InstancedTriangle<Scalar>>) {
    return surface.distance_range(direction, t, rounding);
  } else {
    return distance_range(in_double(surface), in_double(direction), t, rounding);
  }
}

}  // namespace pyrasim
