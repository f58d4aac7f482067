// SPDX-License-Identifier: Apache-2.0
// Extremes: tori seen from far, from their holes and from within their tubes, far from the world's origin.
#include "camera/observer_frame.h"
#include "far_hits.h"
#include "numeric/round_to_format.h"

namespace pyrasim {
namespace {

/// A torus about `center`, its axis any, its tube from 1/16 of its radius to all of it.
Torus torus_about(Random& random, const glm::dvec3& center) {
  const double major = decimal(random.uniform(0.5, 2));
  return {center, decimal(random.unit_vector() * 4.0), major,
          std::max(decimal(major * std::exp2(random.uniform(-4, 0))), 0.05)};
}

/// Of the torus' tube: the middle, somewhere.
glm::dvec3 middle_of_tube(Random& random, const Torus& torus) {
  return torus.center + normalized(cross(torus.axis, random.unit_vector())) * torus.major_radius;
}

/// Rays at a torus `distance` times as far as its radius is long, all of it `origin` from the world's.
template <class Scalar>
FarHits from_far(double distance, double origin) {
  Random random(41);
  FarHits found;
  for (int k = 0; k < 60; ++k) {
    const glm::dvec3 center = whole(random.unit_vector() * origin);
    const Torus torus = torus_about(random, center);
    Scene scene = empty_scene(1, 1, 1);
    scene.camera = decimal_camera(random, 0);
    scene.camera.position = center + whole(random.unit_vector() * std::ceil(distance * torus.major_radius + 2));
    scene.camera.look_at = center;
    scene.objects = {object(torus)};
    const auto tester = make_every_hit(scene, format_of<Scalar>());
    const auto along = [&](const glm::dvec3& v) {
      return exact_distance(scene.objects[0].surface, WorldRay(scene.camera, v));
    };
    const ObserverFrame frame(scene.camera);
    for (int ray = 0; ray < 25; ++ray) {
      const glm::dvec3 place =
          middle_of_tube(random, torus) + random.unit_vector() * (torus.minor_radius * random.uniform(0, 1.5));
      found.add<Scalar>(*tester, along, frame.point(place));
    }
  }
  return found;
}

template <class Scalar>
void expect_few_units(double distance, double origin) {
  const FarHits found = from_far<Scalar>(distance, origin);
  const std::size_t hits = found.of_t.size();
  const double most = found.p99();
  print_figure(fmt::format("torus, distance/radius {}, {} from the origin: p99", distance, origin), format_of<Scalar>(),
               fmt::format("{:.1f} ulp of {} hits, {} wrong", most, hits, found.wrong));
  EXPECT_GT(hits, 300U);
  EXPECT_LE(most, 8);
  EXPECT_EQ(found.wrong, 0);
}

TEST(ExtremesTorus, SeenFromFar) {
  for (const double distance : {3.0, 30.0, 1e3, 1e5}) {
    expect_few_units<double>(distance, 0);
    if (distance < 1e5) expect_few_units<float>(distance, 0);
  }
}

TEST(ExtremesTorus, FarFromTheWorldsOrigin) {
  for (const double distance : {4.0, 100.0}) {
    expect_few_units<double>(distance, 1e5);
    expect_few_units<float>(distance, 1e5);
  }
}

/// Within the tube, from its middle to one unit of the last place from its wall, and looking anywhere. Where the wall
/// is near, t is the difference of two lengths as long as the torus: it errs by their rounding.
TEST(ExtremesTorus, FromWithinTheTubeEveryRayMeetsIt) {
  for_every_format([]<class Scalar>() {
    const NumberFormat format = format_of<Scalar>();
    Random random(42);
    int rays = 0;
    double worst = 0;
    for (int k = 0; k < 150; ++k) {
      const Torus torus = torus_about(random, {0, 0, 0});
      Scene scene = empty_scene(64, 64, 0.03);
      const glm::dvec3 middle = middle_of_tube(random, torus);
      const double part = k % 2 == 0 ? random.uniform(0, 0.9) : 1 - std::exp2(-random.uniform(1, 40));
      scene.camera.position = middle + random.unit_vector() * (torus.minor_radius * part);
      scene.camera.look_at = scene.camera.position + random.unit_vector();
      scene.objects = {object(torus)};
      const auto prepared = prepare_scene(scene, format);
      if (surfaces_of<TorusSurface>(prepared)[0].side == 0) continue;
      const auto surface = rounded<Scalar>(surfaces_of<TorusSurface>(prepared)[0]);
      const double radii = static_cast<double>(surface.major) + static_cast<double>(surface.minor);
      for (int ray = 0; ray < 20; ++ray, ++rays) {
        const auto direction = to_scalar<Scalar>(random.unit_vector());
        const Scalar t = surface.intersect(ViewRay<Scalar>(direction));
        ASSERT_GT(t, Scalar(0)) << part;
        const double furthest = 2 * radii / std::sqrt(static_cast<double>(dot(direction, direction)));
        ASSERT_LE(static_cast<double>(t), furthest * (1 + 8 * static_cast<double>(epsilon<Scalar>())) + radii / 16);
        worst = std::max(worst, static_cast<double>(t) / furthest);
      }
    }
    print_figure("within a torus, 0 lost", format,
                 fmt::format("{} rays, the longest {:.2f} of its width", rays, worst));
    EXPECT_GT(rays, 2000);
  });
}

/// An observer on a torus meets it where he looks into the tube, and not where he looks away from it over its outer
/// rim.
TEST(ExtremesTorus, OnItsSkinNoSelfHits) {
  for_every_format([]<class Scalar>() {
    if (!is_floating<Scalar>) return;
    const double rounding = static_cast<double>(epsilon<Scalar>());
    Random random(43);
    int away = 0, inwards = 0;
    for (int k = 0; k < 150; ++k) {
      const Torus torus = torus_about(random, {0, 0, 0});
      const glm::dvec3 out = normalized(cross(torus.axis, random.unit_vector()));
      Scene scene = empty_scene(64, 64, 0.03);
      scene.camera.position = out * (torus.major_radius + torus.minor_radius);
      scene.camera.look_at = scene.camera.position + random.unit_vector();
      scene.objects = {object(torus)};
      const auto prepared = prepare_scene(scene, format_of<Scalar>());
      ASSERT_EQ(surfaces_of<TorusSurface>(prepared)[0].side, 0);
      const auto surface = rounded<Scalar>(surfaces_of<TorusSurface>(prepared)[0]);
      const glm::dvec3 outward = ObserverFrame(scene.camera).direction(out);
      for (int ray = 0; ray < 20; ++ray) {
        const glm::dvec3 exact = random.unit_vector();
        const double cosine = dot(exact, outward);
        const Scalar t = surface.intersect(ViewRay<Scalar>(to_scalar<Scalar>(exact)));
        if (cosine > 16 * rounding) {
          ASSERT_EQ(t, Scalar(0)) << cosine;
          ++away;
        } else if (cosine < -16 * rounding) {
          ASSERT_GT(t, Scalar(0)) << cosine;
          ++inwards;
        }
      }
    }
    EXPECT_GT(away, 1000);
    EXPECT_GT(inwards, 1000);
  });
}

}  // namespace
}  // namespace pyrasim
