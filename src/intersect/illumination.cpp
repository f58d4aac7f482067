// SPDX-License-Identifier: Apache-2.0
#include "intersect/illumination.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

#include "numeric/number_types.h"
#include "numeric/vectors.h"

namespace pyrasim {
namespace {

bool casts_any(const Scene& scene) {
  return std::any_of(scene.objects.begin(), scene.objects.end(),
                     [](const Object& object) { return object.casts_shadow; });
}

/// Of a direction, in any format: no component is larger than 1.
constexpr double longest_squared = 3;

}  // namespace

template <class Scalar>
Illumination<Scalar>::Illumination(const Scene& description, const PreparedScene<double>& prepared,
                                   const PreparedScene<Scalar>& scene)
    : lights_(*description.lights, ObserverFrame(description.camera), prepared.exponent, casts_any(description)),
      margin_(format_of<Scalar>(), longest_squared, prepared.rounding),
      boxes_(prepared, format_of<Scalar>()),
      rays_(scene, boxes_),
      scene_(scene) {
  if (lights_.with_shadows() == 0) return;
  for (const Object& object : description.objects) casts_shadow_.push_back(object.casts_shadow);
  for_each_kind([&](auto kind) {
    for (const auto& surface : std::get<kind>(prepared.kinds).surfaces) {
      margins_[kind].push_back(2 * margin_.across(surface));
    }
  });
}

template <class Scalar>
typename Illumination<Scalar>::Place Illumination<Scalar>::place_of(const Vector<Scalar>& direction,
                                                                    const Hit<Scalar>& hit) const {
  const glm::dvec3 along = in_double(direction);
  return with_kind(hit.kind, [&](auto kind) {
    const auto& [surfaces, shading] = std::get<kind>(scene_.kinds);
    const auto& surface = surfaces[hit.index];
    const glm::dvec3 outward = in_double(surface.outward(shading[hit.index], direction, hit.t));
    return Place{.position = along * static_cast<double>(hit.t),
                 .normal = (glm::dot(outward, along) < 0 ? outward : -outward) / glm::length(outward),
                 .surface = surface.identity,
                 .margin = margins_[kind].empty() ? 0 : margins_[kind][hit.index]};
  });
}

/// The ray starts so far above the surface that no rounding puts it below, and what it meets within the margin of a
/// surface, or of the light, does not count: there the exact ray may have met nothing.
template <class Scalar>
bool Illumination<Scalar>::in_shadow(const Place& place, const Incidence& incidence, Tests& tests) const {
  const double above = place.margin + 2 * margin_.of(largest(place.position));
  const auto in_format = [](const glm::dvec3& v) { return glm::dvec3(in_double(to_scalar<Scalar>(v))); };
  GeneralRay ray{in_format(place.position + place.normal * above), in_format(incidence.towards)};
  if (incidence.distance < std::numeric_limits<double>::infinity()) {
    ray.limit = incidence.distance - above - 2 * margin_.of(incidence.distance);
  }
  const auto counts = [&](auto kind, std::uint32_t index, double t) {
    return t > margins_[kind][index] && casts_shadow_[std::get<kind>(scene_.kinds).surfaces[index].identity.object];
  };
  return rays_.any(ray, counts, tests);
}

template <class Scalar>
Sample Illumination<Scalar>::sample(const Vector<Scalar>& direction, const Hit<Scalar>& hit, ShadowWork& work) const {
  const Place place = place_of(direction, hit);
  work.lights = lights_.with_shadows();
  glm::dvec3 light = lights_.ambient();
  std::uint32_t blocked = 0;
  lights_.for_each_at(place.position, [&](const Incidence& incidence, const std::optional<std::size_t>& shadow) {
    const double cosine = glm::dot(place.normal, incidence.towards);
    if (!(cosine > 0)) return;  // it is behind, or the surface has no normal there
    if (shadow) {
      ++work.rays[*shadow];
      if (in_shadow(place, incidence, work.tests)) {
        blocked |= 1U << *shadow;
        return;
      }
    }
    light += incidence.color * cosine;
  });
  const auto all = static_cast<std::uint32_t>((std::uint64_t{1} << lights_.with_shadows()) - 1);
  return {{place.surface.object, all & ~blocked}, Shading(light)};
}

template class Illumination<double>;
template class Illumination<float>;
template class Illumination<Flt>;
template class Illumination<Fix>;

}  // namespace pyrasim
