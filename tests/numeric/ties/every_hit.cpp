// SPDX-License-Identifier: Apache-2.0
#include "every_hit.h"

#include "intersect/plane.h"
#include "intersect/ray.h"
#include "intersect/relative_error.h"
#include "intersect/rounded_scene.h"
#include "intersect/sphere.h"
#include "intersect/triangle.h"
#include "numeric/arithmetic_events.h"
#include "numeric/number_types.h"

namespace pyrasim {
namespace {

template <class Scalar>
class EveryHitIn final : public EveryHit {
 public:
  explicit EveryHitIn(const Scene& scene)
      : prepared_(prepare_scene(scene, FormatOf<Scalar>::value)), scene_(rounded<Scalar>(prepared_)) {}

  std::vector<KnownHit> of(const glm::dvec3& view_vector) const override {
    std::vector<KnownHit> hits;
    const auto direction = to_scalar<Scalar>(view_vector);
    const ViewRay<Scalar> ray(direction);
    const auto add = [&](SurfaceKind kind, const auto& surface, Scalar t, double relative_error) {
      const bool saturated = arithmetic_events.saturations > 0;
      if (!(t > Scalar(0))) return;
      const auto value = static_cast<double>(t);
      hits.push_back({kind, surface.identity, value,
                      distance_range(in_double(surface), in_double(direction), value, scene_.rounding), relative_error,
                      saturated});
    };
    for (const auto& plane : scene_.planes) {
      arithmetic_events = {};
      const Scalar t = intersect_plane(plane, direction);
      const auto depth = static_cast<double>(t);
      const bool near = depth * depth <= plane.squared_length * static_cast<double>(ray.inverse_length_squared);
      add(SurfaceKind::plane, plane, t, near ? plane.relative_error : std::numeric_limits<double>::infinity());
    }
    for (std::size_t k = 0; k < scene_.spheres.size(); ++k) {
      arithmetic_events = {};
      const Scalar t = intersect_sphere(scene_.spheres[k], direction, ray.inverse_length_squared);
      add(SurfaceKind::sphere, scene_.spheres[k], t, relative_error(prepared_.spheres[k], prepared_.rounding));
    }
    const TriangleShear<Scalar> shear(direction);
    for (std::size_t k = 0; k < scene_.triangles.size(); ++k) {
      arithmetic_events = {};
      const Scalar t = intersect_triangle(scene_.triangles[k], shear);
      add(SurfaceKind::triangle, scene_.triangles[k], t, relative_error(prepared_.triangles[k], prepared_.rounding));
    }
    return hits;
  }

  int exponent() const override { return scene_.exponent; }

 private:
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
