// SPDX-License-Identifier: Apache-2.0
#include "every_hit.h"

#include "../../intersect/every_surface.h"
#include "intersect/rounded_scene.h"
#include "numeric/arithmetic_events.h"
#include "numeric/number_types.h"

namespace pyrasim {
namespace {

template <class Scalar>
class EveryHitIn final : public EveryHit {
 public:
  explicit EveryHitIn(const Scene& scene)
      : prepared_(prepare_scene(scene, format_of<Scalar>())), scene_(rounded<Scalar>(prepared_)) {}

  std::vector<KnownHit> of(const glm::dvec3& view_vector) const override {
    const FormatScope<Scalar> scope(scene_.numbers);
    std::vector<KnownHit> hits;
    const auto direction = to_scalar<Scalar>(view_vector);
    const ViewRay<Scalar> ray(direction);
    for_each_kind([&](auto kind) {
      for_each_met<kind>(scene_, [&](const auto& surface, std::uint32_t k) {
        using Surface = std::decay_t<decltype(surface)>;
        const typename Surface::Terms terms(ray);
        arithmetic_events = {};
        const Scalar t = surface.intersect(terms);
        const bool saturated = arithmetic_events.saturations > 0;
        if (!(t > Scalar(0))) return;
        const auto value = static_cast<double>(t);
        hits.push_back({kind_at<kind>, surface.identity, value,
                        range_of_met(surface, direction, value, scene_.rounding),
                        error_of(std::get<kind>(prepared_.kinds).surfaces[k], value, ray), saturated});
      });
    });
    return hits;
  }

  int exponent() const override { return scene_.exponent; }

 private:
  template <class Surface>
  double error_of(const Surface& surface, double t, const ViewRay<Scalar>& ray) const {
    if constexpr (SharesMesh<Surface>) {
      return std::numeric_limits<double>::infinity();  // nothing is known before there is a ray
    } else if constexpr (requires { surface.error; }) {
      return surface.error.at(t, static_cast<double>(ray.inverse_length_squared));
    } else {
      return relative_error(surface, prepared_.rounding);
    }
  }

  PreparedScene<double> prepared_;
  PreparedScene<Scalar> scene_;
};

}  // namespace

std::unique_ptr<EveryHit> make_every_hit(const Scene& scene, const NumberFormat& format) {
  return with_number_type(format, [&]<class Scalar>(std::type_identity<Scalar>) -> std::unique_ptr<EveryHit> {
    return std::make_unique<EveryHitIn<Scalar>>(scene);
  });
}

}  // namespace pyrasim
