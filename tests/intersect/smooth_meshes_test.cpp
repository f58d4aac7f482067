// SPDX-License-Identifier: Apache-2.0
// Meshes with normals at their vertices are shaded as the surfaces that they stand for.
#include <gtest/gtest.h>

#include <numbers>

#include "../numeric/extremes/formats.h"
#include "intersect/intersector.h"
#include "numeric/round_to_format.h"

namespace pyrasim {
namespace {

const glm::dvec3 center(6, 0.5, -0.25);

/// A ball of radius 1, its normals times `length`.
Mesh ball(double length) {
  constexpr std::uint32_t around = 48, rows = 24;
  Mesh mesh;
  for (std::uint32_t i = 0; i <= rows; ++i) {
    for (std::uint32_t j = 0; j < around; ++j) {
      const double latitude = std::numbers::pi * i / rows, longitude = 2 * std::numbers::pi * j / around;
      const glm::dvec3 normal(std::sin(latitude) * std::cos(longitude), std::cos(latitude),
                              std::sin(latitude) * std::sin(longitude));
      mesh.vertices.push_back(center + normal);
      mesh.normals.values.push_back(normal * length);
    }
  }
  for (std::uint32_t i = 0; i < rows; ++i) {
    for (std::uint32_t j = 0; j < around; ++j) {
      const auto at = [&](std::uint32_t row, std::uint32_t column) { return row * around + column % around; };
      if (i > 0) mesh.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j)});
      if (i + 1 < rows) mesh.triangles.push_back({at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)});
    }
  }
  mesh.normals.corners = mesh.triangles;
  return mesh;
}

Scene under_single_light(SceneSurface surface) {
  Scene scene = empty_scene(64, 48, 1.0 / 64);
  scene.light = SingleLight{0.25, {0.5, -1, 0.3}};
  scene.objects = {object(std::move(surface))};
  return scene;
}

Scene under_list(SceneSurface surface) {
  Scene scene = under_single_light(std::move(surface));
  scene.light.reset();
  scene.lights = std::vector<Light>{AmbientLight{glm::dvec3(0.25)}, DirectionalLight{{0.5, -1, 0.3}, {1, 1, 1}, false}};
  return scene;
}

double brightness(const Scene& scene, const Sample& sample) {
  return scene.lights ? sample.shading.light().x : sample.shading.factor();
}

/// The largest difference of shading where both scenes are well seen.
double most_apart(const Scene& one, const Scene& other, const NumberFormat& format) {
  const auto first = make_intersector(one, format);
  const auto second = make_intersector(other, format);
  const RoundToFormat round(format);
  Random random(4);
  double most = 0;
  for (int k = 0; k < 4000; ++k) {
    const glm::dvec3 to = center + glm::dvec3(0, random.uniform(-0.8, 0.8), random.uniform(-0.5, 0.5));
    Work work;
    const glm::dvec3 ray(1, round(to.y / to.x), round(to.z / to.x));
    const Sample a = first->intersect(ray, work), b = second->intersect(ray, work);
    EXPECT_EQ(a.seen.object, 0U);
    most = std::max(most, std::abs(brightness(one, a) - brightness(other, b)));
  }
  return most;
}

TEST(SmoothMeshes, AreShadedAsWhatTheyStandFor) {
  const SceneSurface sphere = Sphere{center, 1};
  Mesh flat = ball(1);
  flat.normals = {};
  const SceneSurface instance = MeshInstance{std::make_shared<const InstancedMesh>(ball(1)), {}};
  for (const auto& lit : {under_single_light, under_list}) {
    EXPECT_GT(most_apart(lit(flat), lit(sphere), {}), 0.03);
    EXPECT_LT(most_apart(lit(ball(1)), lit(sphere), {}), 0.01);
    EXPECT_LT(most_apart(lit(instance), lit(sphere), {}), 0.01);
    EXPECT_LT(most_apart(lit(ball(1)), lit(ball(-1)), {}), 1e-12) << "the triangle says which side it is";
    EXPECT_LT(most_apart(lit(ball(1)), lit(instance), {}), 1e-9);
  }
  EXPECT_LT(most_apart(under_single_light(ball(1)), under_single_light(sphere), NumberFormat::single()), 0.01);
  EXPECT_LT(most_apart(under_single_light(ball(1)), under_single_light(sphere), parse_number_format("fix32.20")), 0.01);
}

/// Its normal looks towards the light, the triangle away from it.
TEST(SmoothMeshes, ATriangleThatLooksAwayIsInItsOwnShadow) {
  Mesh mesh;
  mesh.vertices = {{5, -1, -1}, {5, -1, 1}, {5, 2, 0}};
  mesh.triangles = {{0, 1, 2}};
  mesh.normals = {{glm::normalize(glm::dvec3(-1, 0.5, 0))}, {{0, 0, 0}}};
  const auto sample_of = [&](bool shadow) {
    Scene scene = under_list(mesh);
    scene.lights = std::vector<Light>{DirectionalLight{{-0.1, -1, 0}, {1, 1, 1}, shadow}};
    Work work;
    const Sample sample = make_intersector(scene, {})->intersect({1, 0, 0}, work);
    EXPECT_EQ(work.shadow.rays[0], 0U) << "no ray is needed";
    return sample;
  };
  EXPECT_EQ(sample_of(true).seen.lights, 0U);
  EXPECT_EQ(sample_of(true).shading.light(), glm::dvec3(0));
  EXPECT_GT(sample_of(false).shading.light().x, 0.2) << "without shadows only the normal counts";
}

}  // namespace
}  // namespace pyrasim
