// SPDX-License-Identifier: Apache-2.0
// What reaches the place that a view ray meets from a list of lights (decision D5).
//
// The datapath says which surface it is, at what t, and what normal it has there, and follows the shadow rays, all in
// its number format. The rest is worked out in double: a light that fades by 1 / d^2 has a range that a narrow
// fixed-point format does not.
#pragma once

#include <cstdint>
#include <optional>

#include "intersect/shadow_rays.h"
#include "intersect/standing.h"
#include "raster/sample.h"
#include "shading/incidence.h"

namespace pyrasim {

/// Holds a reference: `scene` must outlive it, and stay where it is.
template <class Scalar>
class Illumination {
 public:
  /// Where the scene has a list of lights. `scene` is `prepared` rounded to the format that is set; `description` is
  /// what both were made from.
  Illumination(const Scene& description, const PreparedScene<double>& prepared, const PreparedScene<Scalar>& scene);

  std::size_t lights_with_shadows() const { return lights_.with_shadows(); }
  /// Of the shadow rays' hierarchy.
  std::size_t inner_nodes() const { return shadow_rays_ ? shadow_rays_->inner_nodes() : 0; }

  /// The sample of a ray along `direction` that met `hit`; adds the shadow rays to `work`.
  Sample sample(const Vector<Scalar>& direction, const Hit<Scalar>& hit, ShadowWork& work) const;

 private:
  /// A place on a surface, seen from one side.
  struct Place {
    glm::dvec3 position;
    glm::dvec3 normal;          ///< on the viewer's side, of length 1
    glm::dvec3 shading_normal;  ///< likewise; of a smooth surface that triangles stand for
    std::uint32_t object;
  };

  Place place_of(const Vector<Scalar>& direction, const Hit<Scalar>& hit) const;
  bool in_shadow(const Place& place, const Hit<Scalar>& hit, const Incidence& incidence, std::size_t light,
                 ShadowWork& work) const;

  PreparedLights lights_;
  const PreparedScene<Scalar>& scene_;
  std::optional<ShadowRays<Scalar>> shadow_rays_;  ///< where a light has shadows
};

extern template class Illumination<double>;
extern template class Illumination<float>;
extern template class Illumination<Flt>;
extern template class Illumination<Fix>;

}  // namespace pyrasim
