// SPDX-License-Identifier: Apache-2.0
#include "intersect/illumination.h"

#include <glm/geometric.hpp>

#include "numeric/number_types.h"

namespace pyrasim {

template <class Scalar>
Illumination<Scalar>::Illumination(const Scene& description, const PreparedScene<double>& prepared,
                                   const PreparedScene<Scalar>& scene)
    : lights_(*description.lights, ObserverFrame(description.camera), prepared.exponent, casts_any_shadow(description)),
      scene_(scene) {
  if (lights_.with_shadows() > 0) shadow_rays_.emplace(description, prepared, scene);
}

template <class Scalar>
typename Illumination<Scalar>::Place Illumination<Scalar>::place_of(const Vector<Scalar>& direction,
                                                                    const Hit<Scalar>& hit) const {
  const glm::dvec3 along = in_double(direction);
  const auto place = [&](const glm::dvec3& outward, const SurfaceIdentity& identity) {
    const glm::dvec3 normal = (glm::dot(outward, along) < 0 ? outward : -outward) / glm::length(outward);
    return Place{.position = along * static_cast<double>(hit.t),
                 .normal = normal,
                 .shading_normal = normal,
                 .object = identity.object};
  };
  // On the side of the triangle's own normal, which says what the viewer's side is.
  const auto smooth_place = [&](const glm::dvec3& outward, const glm::dvec3& shading_normal,
                                const SurfaceIdentity& identity) {
    Place smooth = place(outward, identity);
    smooth.shading_normal =
        (glm::dot(outward, along) < 0 ? shading_normal : -shading_normal) / glm::length(shading_normal);
    return smooth;
  };
  return with_kind(hit.kind, [&](auto kind) {
    if constexpr (kind == index_of_kind<InstanceSurface>) {
      const InstancedTriangle<Scalar> triangle = triangle_of_hit(scene_, hit.index);
      const glm::dvec3 outward = in_double(triangle.outward());
      if (!triangle.smooth()) return place(outward, triangle.identity);
      return smooth_place(outward, in_double(triangle.shading_normal(direction)), triangle.identity);
    } else {
      const auto& [surfaces, shading] = std::get<kind>(scene_.kinds);
      const auto& surface = surfaces[hit.index];
      const auto& how = shading[hit.index];
      const glm::dvec3 outward = in_double(surface.outward(how, direction, hit.t));
      if constexpr (kind == index_of_kind<TriangleSurface>) {
        if (how.normals) {
          return smooth_place(outward, in_double(surface.shading_normal(how, direction)), surface.identity);
        }
      }
      return place(outward, surface.identity);
    }
  });
}

/// Where the triangle that stands for a smooth surface looks away from a light, it is in its own shadow.
template <class Scalar>
bool Illumination<Scalar>::in_shadow(const Place& place, const Hit<Scalar>& hit, const Incidence& incidence,
                                     std::size_t light, ShadowWork& work) const {
  if (!(glm::dot(place.normal, incidence.towards) > 0)) return true;
  ++work.rays[light];
  return shadow_rays_->blocked(hit, place.position, place.normal, incidence, work.tests);
}

template <class Scalar>
Sample Illumination<Scalar>::sample(const Vector<Scalar>& direction, const Hit<Scalar>& hit, ShadowWork& work) const {
  const Place place = place_of(direction, hit);
  glm::dvec3 light = lights_.ambient();
  auto reached = static_cast<std::uint32_t>((std::uint64_t{1} << lights_.with_shadows()) - 1);
  lights_.for_each_at(place.position, [&](const Incidence& incidence, const std::optional<std::size_t>& shadow) {
    const double cosine = glm::dot(place.shading_normal, incidence.towards);
    if (!(cosine > 0)) return;  // it is behind, or the surface has no normal there
    if (shadow && in_shadow(place, hit, incidence, *shadow, work)) {
      reached &= ~(1U << *shadow);
      return;
    }
    light += incidence.color * cosine;
  });
  return {{place.object, reached}, Shading(light)};
}

template class Illumination<double>;
template class Illumination<float>;
template class Illumination<Flt>;
template class Illumination<Fix>;

}  // namespace pyrasim
