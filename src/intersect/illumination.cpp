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
    return Place{.position = along * static_cast<double>(hit.t),
                 .normal = (glm::dot(outward, along) < 0 ? outward : -outward) / glm::length(outward),
                 .object = identity.object};
  };
  return with_kind(hit.kind, [&](auto kind) {
    if constexpr (kind == index_of_kind<InstanceSurface>) {
      const InstancedTriangle<Scalar> triangle = triangle_of_hit(scene_, hit.index);
      return place(in_double(triangle.outward()), triangle.identity);
    } else {
      const auto& [surfaces, shading] = std::get<kind>(scene_.kinds);
      const auto& surface = surfaces[hit.index];
      return place(in_double(surface.outward(shading[hit.index], direction, hit.t)), surface.identity);
    }
  });
}

template <class Scalar>
Sample Illumination<Scalar>::sample(const Vector<Scalar>& direction, const Hit<Scalar>& hit, ShadowWork& work) const {
  const Place place = place_of(direction, hit);
  glm::dvec3 light = lights_.ambient();
  auto reached = static_cast<std::uint32_t>((std::uint64_t{1} << lights_.with_shadows()) - 1);
  lights_.for_each_at(place.position, [&](const Incidence& incidence, const std::optional<std::size_t>& shadow) {
    const double cosine = glm::dot(place.normal, incidence.towards);
    if (!(cosine > 0)) return;  // it is behind, or the surface has no normal there
    if (shadow) {
      ++work.rays[*shadow];
      if (shadow_rays_->blocked(hit, place.position, place.normal, incidence, work.tests)) {
        reached &= ~(1U << *shadow);
        return;
      }
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
