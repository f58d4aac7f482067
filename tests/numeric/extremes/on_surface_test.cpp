// SPDX-License-Identifier: Apache-2.0
// Extremes: an observer on a sphere, or inside it. His place is computed in double, so that it is only nearly on it.
#include "../real.h"
#include "formats.h"
#include "intersect/rounded_scene.h"
#include "surface/sphere.h"
#include "surface/view_ray.h"

namespace pyrasim {
namespace {

/// An observer at a random point of a random sphere, up to 1e3 from the world's origin, who looks anywhere.
Scene standing_on_a_sphere(Random& random) {
  Scene scene = empty_scene(64, 64, 0.03);
  const Sphere sphere{random.vector(-1, 1) * std::exp2(random.uniform(-3, 10)), std::exp2(random.uniform(-6, 6))};
  scene.camera.position = sphere.center + random.unit_vector() * sphere.radius;
  scene.camera.look_at = scene.camera.position + random.unit_vector();
  scene.camera.up = random.unit_vector();
  scene.objects = {object(sphere)};
  return scene;
}

/// Rays that point away from the centre never meet the sphere that the observer stands on; those that point inwards
/// meet its far side, at the chord's length; that is a scalar product, and as exact as its terms cancel little. Left
/// apart are rays within 4 roundings of the tangent plane: they are not told apart, and what they hit is as near as
/// that.
TEST(ExtremesOnSurface, NoSelfHitsAndTheFarSideIsSeen) {
  for_every_format([]<class Scalar>() {
    if (!is_floating<Scalar>) return;
    const double rounding = static_cast<double>(epsilon<Scalar>()) / 2;
    constexpr double not_cancelling = 0.25;
    Random random(11);
    int away = 0;
    int inwards = 0;
    Errors errors;
    for (int s = 0; s < 100; ++s) {
      const auto prepared = prepare_scene(standing_on_a_sphere(random), format_of<Scalar>());
      ASSERT_EQ(surfaces_of<SphereSurface>(prepared)[0].power, 0);
      const auto sphere = rounded<Scalar>(surfaces_of<SphereSurface>(prepared)[0]);
      const RealVector center = real(sphere.center);
      for (int k = 0; k < 60; ++k) {
        const auto direction = to_scalar<Scalar>(random.unit_vector());
        const RealVector d = real(direction);
        const Real cosine = dot(center, d) / sqrt(dot(center, center) * dot(d, d));
        const Scalar t = sphere.intersect(ViewRay<Scalar>(direction));
        if (cosine < Real(-4 * rounding)) {
          ASSERT_EQ(t, Scalar(0)) << static_cast<double>(cosine);
          ++away;
        } else if (cosine > Real(4 * rounding)) {
          ASSERT_GT(t, Scalar(0)) << static_cast<double>(cosine);
          ++inwards;
          if (cosine > Real(not_cancelling)) errors.add(error_in_ulp(t, Real(2) * dot(center, d) / dot(d, d)));
        }
      }
    }
    EXPECT_GT(away, 2000);
    EXPECT_GT(inwards, 2000);
    print_figure("on a sphere, 0 self-hits; far side", format_of<Scalar>(), errors.text());
    EXPECT_LE(errors.largest(), 16);
  });
}

/// From inside, the wall is seen everywhere, however near it is: down to one unit of the centre's last place.
/// In fixed point 1 / direction . direction has few significant bits, and t errs by what it is multiplied with: a
/// distance of up to 2^16 in 64.12.
TEST(ExtremesOnSurface, FromInsideEveryRayMeetsTheSphere) {
  for_every_format([]<class Scalar>() {
    const double last_place = spacing<Scalar>(0.75);
    Random random(12);
    Errors errors;
    for (int s = 0; s < 200; ++s) {
      const double center = std::min(as_held<Scalar>(1 - std::exp2(-random.uniform(0, 30))), 1 - last_place);
      Scene scene = empty_scene(64, 64, 0.03);
      scene.objects = {object(Sphere{{0, center, 0}, 1})};
      const auto prepared = prepare_scene(scene, format_of<Scalar>());
      const auto sphere = rounded<Scalar>(surfaces_of<SphereSurface>(prepared)[0]);
      const Real scale = std::ldexp(1.0, prepared.exponent);
      for (int k = 0; k < 40; ++k) {
        glm::dvec3 v(k % 4 < 2 ? 1 : -1, random.uniform(-1, 1), random.uniform(-1, 1));
        if (k % 2 == 0) v.y *= std::exp2(-random.uniform(0, 20));  // nearly along the wall
        const auto direction = to_scalar<Scalar>(v);
        const Scalar t = sphere.intersect(ViewRay<Scalar>(direction));
        ASSERT_GT(t, Scalar(0)) << 1 - center << " " << v.y;
        const RealVector d = real(direction);
        const Real along = Real(center) * d.y;
        const Real root = sqrt(along * along + dot(d, d) * (Real(1) - Real(center) * Real(center)));
        errors.add(error_in_ulp(t, scale * (along + root) / dot(d, d)));
      }
    }
    print_figure("inside a sphere, 0 lost", format_of<Scalar>(), errors.text());
    EXPECT_LE(errors.largest(), is_floating<Scalar> ? 16 : 0x1p16);
  });
}

}  // namespace
}  // namespace pyrasim
