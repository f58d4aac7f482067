// SPDX-License-Identifier: Apache-2.0
// Every hit of a ray, in any number format, with all that is known of it; and decision D7 by its definition.
#pragma once

#include <memory>
#include <vector>

#include "numeric/number_format.h"
#include "scene/scene.h"
#include "surface/distance_range.h"
#include "surface/list.h"

namespace pyrasim {

struct KnownHit {
  SurfaceKind kind;
  SurfaceIdentity identity;
  double t;
  DistanceRange range;    ///< in which the exact hit lies
  double relative_error;  ///< the coarser bound; infinite where there is none
  bool saturated;         ///< a number was too large for the format: nothing is known of t
};

/// Tests all surfaces of one scene.
class EveryHit {
 public:
  EveryHit() = default;
  EveryHit(const EveryHit&) = delete;
  EveryHit& operator=(const EveryHit&) = delete;
  virtual ~EveryHit() = default;

  /// Along a view vector, which is rounded to the format first.
  virtual std::vector<KnownHit> of(const glm::dvec3& view_vector) const = 0;
  /// A length of the datapath is the scene's times 2^exponent.
  virtual int exponent() const = 0;
};

std::unique_ptr<EveryHit> make_every_hit(const Scene& scene, const NumberFormat& format);

/// The object that is seen: of the hits that do not certainly lie behind another one, the first in the scene.
inline std::uint32_t object_seen(const std::vector<KnownHit>& hits) {
  double end = std::numeric_limits<double>::infinity();
  for (const KnownHit& hit : hits) end = std::min(end, hit.range.highest);
  SurfaceIdentity first{~std::uint32_t{0}, ~std::uint32_t{0}};
  for (const KnownHit& hit : hits) {
    if (hit.range.lowest <= end && hit.identity.order < first.order) first = hit.identity;
  }
  return first.object;
}

}  // namespace pyrasim
