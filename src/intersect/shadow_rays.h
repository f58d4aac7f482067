// SPDX-License-Identifier: Apache-2.0
// Rays from the places that are seen to lights, in the datapath's number format.
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "intersect/general_walk.h"
#include "intersect/standing.h"
#include "numeric/vectors.h"
#include "shading/incidence.h"

namespace pyrasim {

/// Whether there is anything that darkens.
inline bool casts_any_shadow(const Scene& scene) {
  return std::any_of(scene.objects.begin(), scene.objects.end(),
                     [](const Object& object) { return object.casts_shadow; });
}

/// Holds a reference: `scene` must outlive it, and stay where it is.
template <class Scalar>
class ShadowRays {
 public:
  /// `scene` is `prepared` rounded to the format that is set; `description` is what both were made from.
  ShadowRays(const Scene& description, const PreparedScene<double>& prepared, const PreparedScene<Scalar>& scene);
  ShadowRays(const ShadowRays&) = delete;
  ShadowRays& operator=(const ShadowRays&) = delete;

  /// Whether something stands between a light and the place `position` on the surface of `hit`, seen from the side of
  /// `normal`. Adds the tests made.
  ///
  /// The ray starts so far above the surface that no rounding puts it below, and what it meets within the margin of a
  /// surface, or of the light, does not count: there the exact ray may have met nothing.
  bool blocked(const Hit<Scalar>& hit, const glm::dvec3& position, const glm::dvec3& normal, const Incidence& incidence,
               Tests& tests) const;

  std::size_t inner_nodes() const { return boxes_.hierarchy().nodes().size(); }

 private:
  const PreparedScene<Scalar>& scene_;
  RayBoxes boxes_;
  GeneralScene<Scalar> rays_{scene_, boxes_};
  std::vector<bool> casts_shadow_;                          ///< by object
  std::array<std::vector<double>, surface_kinds> margins_;  ///< how far from each surface a hit may lie
};

template <class Scalar>
ShadowRays<Scalar>::ShadowRays(const Scene& description, const PreparedScene<double>& prepared,
                               const PreparedScene<Scalar>& scene)
    : scene_(scene), boxes_(prepared, format_of<Scalar>()) {
  for (const Object& object : description.objects) casts_shadow_.push_back(object.casts_shadow);
  for_each_kind([&](auto kind) {
    for (const auto& surface : std::get<kind>(prepared.kinds).surfaces) {
      margins_[kind].push_back(2 * boxes_.margin().across(surface));
    }
  });
}

template <class Scalar>
bool ShadowRays<Scalar>::blocked(const Hit<Scalar>& hit, const glm::dvec3& position, const glm::dvec3& normal,
                                 const Incidence& incidence, Tests& tests) const {
  const std::uint32_t surface = hit.kind == kind_of<InstanceSurface> ? instance_of_hit(scene_, hit.index) : hit.index;
  const double above =
      margins_[static_cast<std::size_t>(hit.kind)][surface] + 2 * boxes_.margin().of(largest(position));
  const auto in_format = [](const glm::dvec3& v) { return glm::dvec3(in_double(to_scalar<Scalar>(v))); };
  GeneralRay ray{in_format(position + normal * above), in_format(incidence.towards)};
  if (incidence.distance < std::numeric_limits<double>::infinity()) {
    ray.limit = incidence.distance - above - 2 * boxes_.margin().of(incidence.distance);
  }
  const auto counts = [&](auto kind, std::uint32_t index, double t) {
    return t > margins_[kind][index] && casts_shadow_[std::get<kind>(scene_.kinds).surfaces[index].identity.object];
  };
  return rays_.any(ray, counts, tests);
}

}  // namespace pyrasim
