// SPDX-License-Identifier: Apache-2.0
// Extremes: planes far from the world's origin, and seen at grazing angles.
#include "surface/plane.h"

#include "../real.h"
#include "formats.h"
#include "intersect/rounded_scene.h"

namespace pyrasim {
namespace {

template <class Scalar>
Scalar t_of_plane(const Vector<Scalar>& normal, Scalar offset, const Vector<Scalar>& direction) {
  return PlaneSurface<Scalar>{normal, offset}.intersect(ViewRay<Scalar>(direction));
}

/// Rays at 1e-6 to the plane, or 2^(4-P) where the format is too narrow to aim so well. The normal is the format's own.
TEST(ExtremesPlane, GrazingRays) {
  for_every_format([]<class Scalar>() {
    if (!is_floating<Scalar>) return;
    const double angle = std::max(1e-6, std::ldexp(1.0, 4 - significand_bits<Scalar>()));
    Random random(5);
    Errors errors;
    for (int k = 0; k < 5000; ++k) {
      const glm::dvec3 unit = random.unit_vector();
      const auto normal = to_scalar<Scalar>(unit);
      const glm::dvec3 along = random.unit_vector();
      const glm::dvec3 grazing = along - unit * (dot(along, unit) - angle);
      if (!(grazing.x > 0.1)) continue;
      const auto direction = to_scalar<Scalar>(grazing / grazing.x);
      const Real approach = dot(real(normal), real(direction));
      const auto sine = static_cast<double>(approach) / std::sqrt(dot(grazing, grazing)) * grazing.x;
      if (!(sine > angle / 2 && sine < angle * 2)) continue;
      const auto offset = static_cast<Scalar>(random.uniform(1, 10));
      errors.add(error_in_ulp(t_of_plane(normal, offset, direction), Real(static_cast<double>(offset)) / approach));
    }
    ASSERT_GT(errors.count(), 200U);
    EXPECT_LE(errors.largest(), 3);
    print_figure(fmt::format("plane at {:.1e}", angle), format_of<Scalar>(), errors.text());
  });
}

/// Planes 1e6 from the world's origin, 1 to 10 from an observer who stands there too, whole-number normals of any
/// length, which every format holds: what remains is the rounding of offset, scalar product and division.
TEST(ExtremesPlane, FarFromTheOrigin) {
  for_every_format([]<class Scalar>() {
    if (!is_floating<Scalar>) return;
    Random random(6);
    Errors errors;
    for (int k = 0; k < 3000; ++k) {
      Scene scene = empty_scene(64, 64, 0.03);
      const glm::dvec3 position = random.vector(-1e6, 1e6);
      scene.camera.position = position;
      scene.camera.look_at = position + glm::dvec3(1, 0, 0);
      const glm::dvec3 normal(std::floor(random.uniform(4, 8)), std::floor(random.uniform(-7, 8)),
                              std::floor(random.uniform(-7, 8)));
      const double offset = dot(normal, position + glm::dvec3(random.uniform(1, 10), 0, 0));
      scene.objects = {object(Plane{normal, offset})};
      const auto prepared = prepare_scene(scene, format_of<Scalar>());
      const auto direction = to_scalar<Scalar>({1, random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2)});
      const Real approach = dot(real(normal), real(direction));
      const Real distance = Real(offset) - dot(real(normal), real(position));
      if (approach < Real(1)) continue;
      const Real exact = Real(std::ldexp(1.0, prepared.exponent)) * distance / approach;
      const Scalar t = rounded<Scalar>(surfaces_of<PlaneSurface>(prepared)[0]).intersect(ViewRay<Scalar>(direction));
      errors.add(error_in_ulp(t, exact));
    }
    ASSERT_GT(errors.count(), 1000U);
    print_figure("plane 1e6 from the origin", format_of<Scalar>(), errors.text());
    EXPECT_LE(errors.largest(), 3);
  });
}

}  // namespace
}  // namespace pyrasim
