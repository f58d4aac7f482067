// SPDX-License-Identifier: Apache-2.0
// Extremes: scenes 2^k times as large, and scenes far from the world's origin.

#include "formats.h"
#include "intersect/prepared_scene.h"

namespace pyrasim {
namespace {

glm::dvec3 times(const glm::dvec3& v, double factor) { return v * factor; }

/// All lengths times 2^k, the screen's too. Directions keep theirs.
Scene scaled(Scene scene, int k) {
  const double factor = std::ldexp(1.0, k);
  Camera& camera = scene.camera;
  camera.position = times(camera.position, factor);
  camera.look_at = times(camera.look_at, factor);
  for (double* length : {&camera.screen.dx, &camera.screen.dy, &camera.screen.dz}) *length *= factor;
  for (Object& object : scene.objects) {
    if (auto* sphere = std::get_if<Sphere>(&object.surface)) {
      *sphere = {times(sphere->center, factor), sphere->radius * factor};
    } else if (auto* plane = std::get_if<Plane>(&object.surface)) {
      plane->offset *= factor;
    } else if (auto* triangle = std::get_if<Triangle>(&object.surface)) {
      for (glm::dvec3& vertex : triangle->vertices) vertex = times(vertex, factor);
    } else if (auto* disc = std::get_if<Disc>(&object.surface)) {
      *disc = {times(disc->center, factor), disc->normal, disc->radius * factor};
    } else if (auto* box = std::get_if<Box>(&object.surface)) {
      *box = {times(box->min, factor), times(box->max, factor)};
    } else if (auto* ellipsoid = std::get_if<Ellipsoid>(&object.surface)) {
      *ellipsoid = {times(ellipsoid->center, factor), times(ellipsoid->radii, factor)};
    } else if (auto* cylinder = std::get_if<Cylinder>(&object.surface)) {
      const auto& [base, cap] = cylinder->axis;
      *cylinder = {{times(base, factor), times(cap, factor)}, cylinder->radius * factor, cylinder->capped};
    } else if (auto* cone = std::get_if<Cone>(&object.surface)) {
      const auto& [base, cap] = cone->axis;
      *cone = {{times(base, factor), times(cap, factor)},
               cone->base_radius * factor,
               cone->cap_radius * factor,
               cone->capped};
    } else if (auto* quadric = std::get_if<Quadric>(&object.surface)) {
      auto& of = quadric->coefficients;
      for (double* linear : {&of.x, &of.y, &of.z}) *linear *= factor;
      of.constant = of.constant * factor * factor;
      for (auto& half_space : quadric->clip) half_space.offset *= factor;
    } else if (auto* torus = std::get_if<Torus>(&object.surface)) {
      *torus = {times(torus->center, factor), torus->axis, torus->major_radius * factor, torus->minor_radius * factor};
    } else if (auto* instance = std::get_if<MeshInstance>(&object.surface)) {
      instance->map = AffineMap::scaling(glm::dvec3(factor)).after(instance->map);
    }
  }
  return scene;
}

/// A scene with every kind of surface, seen by a camera that looks askew.
Scene askew_scene() {
  Scene scene = random_scene(31, {8, 8, 2, 4, 4, 8, 4, 4}, 24, 18);
  scene.camera.position = {-1, 0.3, 0.7};
  scene.camera.look_at = {3, 0.1, 0.2};
  scene.camera.up = {0.1, 1, -0.2};
  return scene;
}

TEST(ExtremesScale, PicturesAreEqualBitForBitAtEveryPowerOfTwo) {
  const Scene scene = askew_scene();
  for (const NumberFormat& format : number_formats()) {
    const Image expected = picture(scene, format);
    for (const int k : {-100, -40, 1, 40, 100}) {
      EXPECT_TRUE(picture(scaled(scene, k), format).pixels() == expected.pixels()) << format.name() << ' ' << k;
    }
  }
}

/// The datapath is given the same numbers; so t, which counts in them, scales with the scene.
TEST(ExtremesScale, TheDatapathSeesTheSameNumbers) {
  const Scene scene = askew_scene();
  for (const NumberFormat& format : number_formats()) {
    const auto expected = prepare_scene(scene, format);
    for (const int k : {-100, -40, 1, 40, 100}) {
      const auto prepared = prepare_scene(scaled(scene, k), format);
      EXPECT_EQ(prepared.exponent, expected.exponent - k);
      ASSERT_EQ(surfaces_of<SphereSurface>(prepared).size(), surfaces_of<SphereSurface>(expected).size());
      for (std::size_t s = 0; s < surfaces_of<SphereSurface>(prepared).size(); ++s) {
        EXPECT_EQ(surfaces_of<SphereSurface>(prepared)[s].center, surfaces_of<SphereSurface>(expected)[s].center);
        EXPECT_EQ(surfaces_of<SphereSurface>(prepared)[s].radius_squared,
                  surfaces_of<SphereSurface>(expected)[s].radius_squared);
        EXPECT_EQ(surfaces_of<SphereSurface>(prepared)[s].power, surfaces_of<SphereSurface>(expected)[s].power);
        EXPECT_EQ(surfaces_of<SphereSurface>(prepared)[s].radius, surfaces_of<SphereSurface>(expected)[s].radius);
      }
      for (std::size_t s = 0; s < surfaces_of<TriangleSurface>(prepared).size(); ++s) {
        EXPECT_EQ(surfaces_of<TriangleSurface>(prepared)[s].vertices,
                  surfaces_of<TriangleSurface>(expected)[s].vertices);
      }
      for (std::size_t s = 0; s < surfaces_of<PlaneSurface>(prepared).size(); ++s) {
        EXPECT_EQ(surfaces_of<PlaneSurface>(prepared)[s].offset, surfaces_of<PlaneSurface>(expected)[s].offset);
      }
    }
  }
}

/// A multiple of 2^-10: added to 1e6 it stays exact.
glm::dvec3 coarse(const glm::dvec3& v) {
  return {std::round(v.x * 1024) / 1024, std::round(v.y * 1024) / 1024, std::round(v.z * 1024) / 1024};
}

/// A scene of coarse coordinates, everything moved by `offset`.
Scene moved_scene(const glm::dvec3& offset) {
  Random random(17);
  Scene scene = empty_scene(24, 18, 0.05);
  scene.light = SingleLight{0.25, {0.6, -1, 0.4}};
  scene.camera.position = offset + glm::dvec3(-1, 0.25, 0.5);
  scene.camera.look_at = offset + glm::dvec3(3, 0.125, 0.25);
  const auto place = [&] {
    return coarse({random.uniform(3, 12), random.uniform(-3, 3), random.uniform(-4, 4)}) + offset;
  };
  for (int k = 0; k < 8; ++k) {
    scene.objects.push_back(object(Sphere{place(), random.uniform(0.05, 1.2)}, random.vector(0, 1)));
    const glm::dvec3 a = place();
    const auto near = [&] { return a + coarse(random.vector(-2, 2)); };
    scene.objects.push_back(object(Triangle{{a, near(), near()}}, random.vector(0, 1)));
  }
  const glm::dvec3 normal(0.125, 1, -0.25);
  scene.objects.push_back(object(Plane{normal, dot(normal, offset) - 3}, random.vector(0, 1)));
  return scene;
}

TEST(ExtremesScale, AMillionAwayFromTheOriginNothingChanges) {
  for (const NumberFormat& format : number_formats()) {
    const Image expected = picture(moved_scene({0, 0, 0}), format);
    for (const glm::dvec3& offset : {glm::dvec3(1e6, 0, 0), glm::dvec3(-1e6, 1e6, 2e6)}) {
      EXPECT_TRUE(picture(moved_scene(offset), format).pixels() == expected.pixels()) << format.name();
    }
  }
}

}  // namespace
}  // namespace pyrasim
