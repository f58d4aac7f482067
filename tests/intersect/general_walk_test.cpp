// SPDX-License-Identifier: Apache-2.0
// Rays from anywhere: the hierarchy finds what testing every surface finds, in every number format, and that is what
// there is.
#include "intersect/general_walk.h"

#include <gtest/gtest.h>

#include "../numeric/extremes/formats.h"
#include "../numeric/ties/exact_distance.h"
#include "every_surface.h"

namespace pyrasim {
namespace {

Scene mixed_scene(std::uint64_t seed) { return random_scene(seed, {25, 40, 2, 20, 20, 40, 20, 15}, 8, 8); }

/// A scene in one format, for rays from anywhere.
template <class Scalar>
class Prepared {
 public:
  explicit Prepared(const Scene& scene)
      : exact_(prepare_scene(scene, format_of<Scalar>())),
        boxes_(exact_, format_of<Scalar>()),
        scene_(rounded<Scalar>(exact_)) {}
  GeneralScene<Scalar> hierarchy() const { return {scene_, boxes_}; }
  std::optional<GeneralHit> by_testing_every_surface(const GeneralRay& ray) const;
  double unit() const { return std::ldexp(1.0, exact_.exponent); }

 private:
  PreparedScene<double> exact_;
  RayBoxes boxes_;
  PreparedScene<Scalar> scene_;
};

template <class Scalar>
std::optional<GeneralHit> Prepared<Scalar>::by_testing_every_surface(const GeneralRay& ray) const {
  const FormatScope<Scalar> scope(scene_.numbers);
  const ViewRay<Scalar> moved(to_scalar<Scalar>(ray.direction));
  std::optional<GeneralHit> nearest;
  for_each_kind([&](auto kind) {
    for_each_met<kind>(scene_, [&](const auto& surface, std::uint32_t) {
      const typename std::decay_t<decltype(surface)>::Terms terms(moved);
      const auto t = static_cast<double>(surface.seen_from(to_scalar<Scalar>(ray.origin)).intersect(terms));
      if (!(t > 0) || t > ray.limit) return;
      const bool first =
          !nearest || t < nearest->t || (t == nearest->t && surface.identity.order < nearest->surface.order);
      if (first) nearest = GeneralHit{t, surface.identity};
    });
  });
  return nearest;
}

/// From among the surfaces, from outside and from the observer; anywhere, along axes, and with a limit or without.
template <class Scalar>
GeneralRay random_ray(Random& random, double unit) {
  const auto held = [](const glm::dvec3& v) {
    return glm::dvec3(as_held<Scalar>(v.x), as_held<Scalar>(v.y), as_held<Scalar>(v.z));
  };
  glm::dvec3 origin = glm::dvec3(7, 0, 0) + random.vector(-1, 1) * (random.below(4) == 0 ? 14.0 : 5.0);
  if (random.below(16) == 0) origin = glm::dvec3(0);
  glm::dvec3 direction = random.unit_vector();
  if (random.below(8) == 0) direction[static_cast<int>(random.below(3))] = 0;
  if (random.below(16) == 0) direction = glm::dvec3(0, random.below(2) == 0 ? -1 : 1, 0);
  GeneralRay ray{held(origin * unit), held(direction)};
  if (random.below(3) == 0) ray.limit = random.uniform(0, 12) * unit;
  return ray;
}

template <class Scalar>
void expect_what_every_test_finds(int scenes, int rays_each) {
  SCOPED_TRACE(format_of<Scalar>().name());
  Random random(91);
  int hits = 0;
  std::uint64_t tests = 0, all_tests = 0;
  for (int k = 0; k < scenes; ++k) {
    const Prepared<Scalar> prepared(mixed_scene(static_cast<std::uint64_t>(k) + 1));
    for (int r = 0; r < rays_each; ++r) {
      const GeneralRay ray = random_ray<Scalar>(random, prepared.unit());
      if (!(dot(ray.direction, ray.direction) > 0)) continue;
      Work work, unused;
      const auto nearest = prepared.hierarchy().nearest(ray, work);
      const auto expected = prepared.by_testing_every_surface(ray);
      ASSERT_EQ(nearest, expected) << k << " " << r << ": " << (expected ? expected->t : 0);
      ASSERT_EQ(prepared.hierarchy().any(ray, unused), expected.has_value()) << k << " " << r;
      if (expected) {
        ASSERT_LE(expected->t, ray.limit);
      }
      hits += expected ? 1 : 0;
      for (const std::uint64_t kind : work.surface_tests) tests += kind;
      all_tests += 167 + 15 * 9;
    }
  }
  EXPECT_GT(hits, scenes * rays_each / 4);
  const NumberFormat format = format_of<Scalar>();
  // In the narrowest formats little is known of where a ray along a cylinder or a cone meets it.
  const bool narrow = format.kind == NumberKind::fixed ? format.fraction_bits < 16 : format.significand_bits < 11;
  if (!narrow) {
    EXPECT_LT(tests, all_tests / 2) << "the hierarchy is of no use";
  }
}

TEST(GeneralRays, AMillionInDoubleFindWhatEveryTestFinds) { expect_what_every_test_finds<double>(20, 50000); }

TEST(GeneralRays, FindWhatEveryTestFindsInEveryFormat) {
  for_every_format([]<class Scalar>() { expect_what_every_test_finds<Scalar>(4, 1500); });
}

/// Whatever format is set where a ray is sent.
TEST(GeneralRays, AreComputedInTheFormatOfTheirScene) {
  const auto prepared_in = [](const NumberFormat& format) {
    const FormatScope<Flt> scope(format);
    return Prepared<Flt>(mixed_scene(2));
  };
  const auto nearest_in = [](const NumberFormat& format, const Prepared<Flt>& scene, const GeneralRay& ray) {
    const FormatScope<Flt> scope(format);
    Work work;
    return scene.hierarchy().nearest(ray, work);
  };
  const Prepared<Flt> coarse = prepared_in(bf16);
  const Prepared<Flt> fine = prepared_in(fp24);
  const FormatScope<Flt> scope(bf16);
  Random random(23);
  int different = 0;
  for (int k = 0; k < 300; ++k) {
    const GeneralRay ray = random_ray<Flt>(random, coarse.unit());
    const auto expected = nearest_in(bf16, coarse, ray);
    ASSERT_EQ(nearest_in(fp24, coarse, ray), expected) << k;
    ASSERT_EQ(nearest_in(bf16, fine, ray), nearest_in(fp24, fine, ray)) << k;
    different += nearest_in(fp24, fine, ray) != expected ? 1 : 0;
  }
  EXPECT_GT(different, 100);
}

/// The scene as decimal numbers.
Scene decimal_scene(Scene scene) {
  for (Object& object : scene.objects) {
    if (auto* sphere = std::get_if<Sphere>(&object.surface)) {
      *sphere = {decimal(sphere->center), decimal(sphere->radius)};
    } else if (auto* plane = std::get_if<Plane>(&object.surface)) {
      *plane = {decimal(plane->normal), decimal(plane->offset)};
    } else if (auto* triangle = std::get_if<Triangle>(&object.surface)) {
      for (glm::dvec3& vertex : triangle->vertices) vertex = decimal(vertex);
    } else if (auto* disc = std::get_if<Disc>(&object.surface)) {
      *disc = {decimal(disc->center), decimal(disc->normal), decimal(disc->radius)};
    } else if (auto* box = std::get_if<Box>(&object.surface)) {
      *box = {decimal(box->min), decimal(box->max)};
    } else if (auto* ellipsoid = std::get_if<Ellipsoid>(&object.surface)) {
      *ellipsoid = {decimal(ellipsoid->center), decimal(ellipsoid->radii)};
    } else if (auto* cylinder = std::get_if<Cylinder>(&object.surface)) {
      cylinder->axis = {decimal(cylinder->axis.base), decimal(cylinder->axis.cap)};
      cylinder->radius = decimal(cylinder->radius);
    } else if (auto* cone = std::get_if<Cone>(&object.surface)) {
      cone->axis = {decimal(cone->axis.base), decimal(cone->axis.cap)};
      cone->base_radius = decimal(cone->base_radius);
      cone->cap_radius = decimal(cone->cap_radius);
    } else if (auto* quadric = std::get_if<Quadric>(&object.surface)) {
      auto& q = quadric->coefficients;
      for (double* number : {&q.xx, &q.yy, &q.zz, &q.xy, &q.xz, &q.yz, &q.x, &q.y, &q.z, &q.constant}) {
        *number = decimal(*number);
      }
      for (auto& half_space : quadric->clip) {
        half_space = {decimal(half_space.normal), decimal(half_space.offset)};
      }
    } else if (auto* torus = std::get_if<Torus>(&object.surface)) {
      *torus = {decimal(torus->center), decimal(torus->axis), decimal(torus->major_radius),
                std::min(decimal(torus->minor_radius), decimal(torus->major_radius))};
    }
  }
  return scene;
}

TEST(GeneralRays, MeetWhatThereIs) {
  const Scene scene = decimal_scene(mixed_scene(5));
  const Prepared<double> prepared(scene);
  Random random(17);
  int hits = 0;
  for (int k = 0; k < 3000; ++k) {
    const glm::dvec3 origin = decimal(glm::dvec3(7, 0, 0) + random.vector(-1, 1) * 5.0);
    const GeneralRay ray{origin * prepared.unit(), random.unit_vector()};
    WorldRay exact(scene.camera, ray.direction);
    exact.origin = written(origin);
    std::optional<Real> nearest;
    for (const Object& object : scene.objects) {
      const auto distance = exact_distance(object.surface, exact);
      if (distance && (!nearest || *distance < *nearest)) nearest = distance;
    }
    Work work;
    const auto found = prepared.hierarchy().nearest(ray, work);
    ASSERT_EQ(found.has_value(), nearest.has_value()) << k;
    if (!found) continue;
    ++hits;
    ASSERT_NEAR(found->t / prepared.unit(), static_cast<double>(*nearest), 1e-9 * static_cast<double>(*nearest) + 1e-12)
        << k;
  }
  EXPECT_GT(hits, 2000);
}

}  // namespace
}  // namespace pyrasim
