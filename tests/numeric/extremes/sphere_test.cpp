// SPDX-License-Identifier: Apache-2.0
// Extremes: far spheres, and an observer just above a huge one.
#include "surface/sphere.h"

#include <optional>

#include "../real.h"
#include "formats.h"
#include "intersect/rounded_scene.h"
#include "surface/view_ray.h"

namespace pyrasim {
namespace {

/// A sphere seen from the origin by way of prepare_scene, beside its exact twin in the same units.
template <class Scalar>
class SeenSphere {
 public:
  SeenSphere(const glm::dvec3& center, double radius) : SeenSphere(center, radius, prepared(center, radius)) {}

  Scalar t(const Vector<Scalar>& direction) const { return surface_.intersect(ViewRay<Scalar>(direction)); }

  /// None where the ray passes the centre by more than `share` of the radius.
  std::optional<Real> exact_t(const Vector<Scalar>& direction, double share) const {
    const RealVector d = real(direction);
    const Real along = dot(center_, d);
    const Real length_squared = dot(d, d);
    const Real across_squared = dot(center_, center_) - along * along / length_squared;
    if (across_squared > Real(share) * Real(share) * radius_squared_) return std::nullopt;
    const Real root = sqrt(along * along - length_squared * power_);
    return (along - root) / length_squared;  // 512 bits: what cancels does not matter
  }

 private:
  static PreparedScene<double> prepared(const glm::dvec3& center, double radius) {
    Scene scene = empty_scene(64, 64, 0.03);
    scene.objects = {object(Sphere{center, radius})};
    return prepare_scene(scene, format_of<Scalar>());
  }

  SeenSphere(const glm::dvec3& center, double radius, const PreparedScene<double>& scene)
      : surface_(rounded<Scalar>(surfaces_of<SphereSurface>(scene)[0])) {
    const Real scale = std::ldexp(1.0, scene.exponent);
    center_ = {scale * center.x, scale * center.y, scale * center.z};
    radius_squared_ = scale * scale * Real(radius) * Real(radius);
    power_ = dot(center_, center_) - radius_squared_;
  }

  SphereSurface<Scalar> surface_;
  RealVector center_;
  Real radius_squared_, power_;
};

/// A direction that passes the centre by `share` of the radius, rounded to the format.
template <class Scalar>
Vector<Scalar> past_center(Random& random, const glm::dvec3& center, double radius, double share) {
  const glm::dvec3 any = random.unit_vector();
  const glm::dvec3 across = any - center * (dot(any, center) / dot(center, center));
  const glm::dvec3 point = center + across * (share * radius / std::sqrt(dot(across, across)));
  return to_scalar<Scalar>(point / point.x);
}

struct FarSphere {
  Errors errors;
  int missed = 0;
};

/// Rays within 0.999 radii of the centre, half of them from 0.99 on.
template <class Scalar>
FarSphere look_at_far_sphere(double ratio, int spheres) {
  FarSphere result;
  Random random(7);
  for (int s = 0; s < spheres; ++s) {
    const glm::dvec3 center(1, as_held<Scalar>(random.uniform(-0.5, 0.5)), as_held<Scalar>(random.uniform(-0.5, 0.5)));
    const double radius = as_held<Scalar>(std::sqrt(dot(center, center)) / ratio);
    const SeenSphere<Scalar> sphere(center, radius);
    for (int k = 0; k < 50; ++k) {
      const double share = k % 2 == 0 ? std::sqrt(random.uniform(0, 0.998)) : random.uniform(0.99, 0.999);
      const auto direction = past_center<Scalar>(random, center, radius, share);
      const auto exact = sphere.exact_t(direction, 0.999);
      if (!exact) continue;  // the direction's own rounding
      const Scalar t = sphere.t(direction);
      if (t > Scalar(0)) {
        result.errors.add(error_in_ulp(t, *exact));
      } else {
        ++result.missed;
      }
    }
  }
  return result;
}

template <class Scalar>
void expect_far_spheres_meet_the_gate() {
  for (const double ratio : {3.0, 30.0, 300.0, 4100.0, 1e5}) {
    const FarSphere far = look_at_far_sphere<Scalar>(ratio, 100);
    print_figure(fmt::format("sphere, distance/radius {}", ratio), format_of<Scalar>(),
                 fmt::format("{}, {} missed", far.errors.text(), far.missed));
    if (significand_bits<Scalar>() > 24 || ratio < 1e5) {
      EXPECT_EQ(far.missed, 0) << ratio;
    } else {
      EXPECT_LE(far.missed, 1) << ratio;  // of 4930: float loses rays at the very rim here
    }
    EXPECT_LE(far.errors.p99(), 4) << ratio;
    EXPECT_LE(far.errors.largest(), 16) << ratio;
    EXPECT_GT(far.errors.count(), 4500U);
  }
}

TEST(ExtremesSphere, FarSpheresInDouble) { expect_far_spheres_meet_the_gate<double>(); }
TEST(ExtremesSphere, FarSpheresInFloat) { expect_far_spheres_meet_the_gate<float>(); }

/// Up to which distance / radius no ray is missed, in steps of 2, and t's errors up to there. The products of t and the
/// direction are rounded by some 2^-P of the distance, and the rays leave 0.001 radii: 1.5 * 2^(P-8), measured. What is
/// hit is as accurate as in double.
TEST(ExtremesSphere, FormatsKeepARatioThatDoublesWithEveryBit) {
  for_every_format([]<class Scalar>() {
    if (!is_floating<Scalar>) return;
    const int p = significand_bits<Scalar>();
    int kept = 0;
    Errors errors;
    for (; kept < 17; ++kept) {
      FarSphere far = look_at_far_sphere<Scalar>(std::ldexp(1.5, kept), 20);
      if (far.missed > 0) break;
      errors = far.errors;
      EXPECT_LE(errors.p99(), 4) << kept;
      EXPECT_LE(errors.largest(), 16) << kept;
    }
    print_figure(fmt::format("sphere, no missed ray to distance/radius 1.5 * 2^{}", kept - 1), format_of<Scalar>(),
                 errors.text());
    EXPECT_GE(kept - 1, std::min(p - 8, 16));
  });
}

/// An observer 1e-5 radii above a sphere, or as little as the format's centre can say, looks down within 60 degrees.
TEST(ExtremesSphere, ObserverJustAboveAHugeSphere) {
  for_every_format([]<class Scalar>() {
    if (!is_floating<Scalar>) return;
    const int p = significand_bits<Scalar>();
    Random random(3);
    Errors errors;
    for (int s = 0; s < 100; ++s) {
      const double radius = as_held<Scalar>(random.uniform(1, 1.9));
      const double height = std::max(1e-5 * radius, std::ldexp(1.0, 1 - p));
      const double center = as_held<Scalar>(radius + height);
      ASSERT_GT(center, radius);
      const SeenSphere<Scalar> sphere({center, 0, 0}, radius);
      for (int k = 0; k < 50; ++k) {
        const auto direction = to_scalar<Scalar>({1, random.uniform(-1.2, 1.2), random.uniform(-1.2, 1.2)});
        const Scalar t = sphere.t(direction);
        ASSERT_GT(t, Scalar(0));
        errors.add(error_in_ulp(t, *sphere.exact_t(direction, 1)));
      }
    }
    EXPECT_LE(errors.largest(), 4);
    print_figure("sphere, observer 1e-5 radii above", format_of<Scalar>(), errors.text());
  });
}

/// From outside t falls as the radius grows, and so it does from inside as it shrinks.
TEST(ExtremesSphere, NearestTIsMonotoneInTheRadius) {
  for_every_format([]<class Scalar>() {
    Random random(9);
    for (int s = 0; s < 40; ++s) {
      const glm::dvec3 center = glm::dvec3(random.uniform(2, 6), random.uniform(-1, 1), random.uniform(-1, 1));
      const auto direction = to_scalar<Scalar>({1, random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5)});
      double last = 0;
      for (int k = 40; k > 0; --k) {
        Scene scene = empty_scene(64, 64, 0.03);
        scene.objects = {object(Sphere{center, 0.045 * k}),
                         object(Sphere{{1, 0, 0}, 9})};  // the second fixes the scale
        const auto prepared = prepare_scene(scene, format_of<Scalar>());
        const auto surface = rounded<Scalar>(surfaces_of<SphereSurface>(prepared)[0]);
        const auto t = static_cast<double>(surface.intersect(ViewRay<Scalar>(direction)));
        if (t == 0) break;  // passed by; smaller ones are too
        ASSERT_GE(t, last) << s << " " << k;
        last = t;
      }
    }
  });
}

}  // namespace
}  // namespace pyrasim
