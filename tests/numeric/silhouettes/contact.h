// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "exact_scene.h"
#include "ray.h"
#include "rounding.h"

namespace pyrasim::silhouettes {

/// How one ray meets, or misses, one surface.
struct Contact {
  SurfaceKind kind;
  std::uint32_t index;  ///< among the scene's surfaces of that kind; triangles, of instances too, are facets
  SurfaceIdentity identity;
  bool hit;
  std::array<double, 3> margins;  ///< discriminant, centre along the ray | n . d | edge functions |
                                  ///< n . d, room within the rim | way inside, to the exit |
                                  ///< least distance from the tube
  double t;                       ///< of the hit; of the nearest approach or the triangle's plane where there is none
  double behind;                  ///< t - that of the nearest hit
};

/// All surfaces, of facets those near the ray: those that a datapath of `rounding` may hit at most.
/// Computed in `Number`: in Real all is exact; in double margins err as those of a datapath in double. The nearest hit
/// comes first, if there is one: at equal distance, the first in the scene (decision D7).
template <class Number>
std::vector<Contact> contacts(const ExactScene& scene, const Ray& ray, const Rounding& rounding);

extern template std::vector<Contact> contacts<double>(const ExactScene&, const Ray&, const Rounding&);
extern template std::vector<Contact> contacts<Real>(const ExactScene&, const Ray&, const Rounding&);

/// What a datapath of some rounding may make of a contact.
struct Verdict {
  bool possible;  ///< it may count as hit
  bool certain;   ///< it must; a triangle, where the ray runs off none of its edges
  std::array<bool, 3> near_edge{};
  double lowest_behind, highest_behind;  ///< the range of `behind` where it counts as hit
  double begins_behind, ends_behind;     ///< and of the range that the datapath grants such a hit (decision D7)
};
Verdict verdict(const ExactScene& scene, const Ray& ray, const Contact& contact, const Rounding& rounding);

}  // namespace pyrasim::silhouettes
