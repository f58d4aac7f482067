// SPDX-License-Identifier: Apache-2.0
// Instances of a mesh are seen as copies of it are, and share it.
#include <gtest/gtest.h>

#include <set>

#include "../numeric/extremes/formats.h"
#include "intersect/instanced_triangle.h"
#include "intersect/scene_intersector.h"
#include "numeric/round_to_format.h"

namespace pyrasim {
namespace {

Scene instances_alone(std::uint64_t seed, int count) { return random_scene(seed, {.instances = count}, 64, 48); }

/// Each with triangles of its own, where the scene's numbers put them.
Scene copied(Scene scene) {
  for (Object& object : scene.objects) {
    const auto& instance = std::get<MeshInstance>(object.surface);
    object.surface = instance.of->mesh.transformed(instance.map);
  }
  return scene;
}

/// But where rounding decides: along outlines.
template <class Scalar>
void expect_seen_as_copies_are(int most_others, double most_shading) {
  int hits = 0;
  int others = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const Scene scene = instances_alone(seed, 60);
    const SceneIntersector<Scalar> shared(scene);
    const SceneIntersector<Scalar> copies(copied(scene));
    Random random(seed);
    for (int k = 0; k < 2500; ++k) {
      const Vector<Scalar> direction(Scalar(1), Scalar(random.uniform(-1, 1)), Scalar(random.uniform(-1, 1)));
      Work work;
      const Sample one = shared.intersect(direction, work);
      const Sample other = copies.intersect(direction, work);
      hits += one.seen.object != no_object ? 1 : 0;
      if (one.seen.object != other.seen.object) {
        ++others;
      } else {
        EXPECT_NEAR(one.shading.factor(), other.shading.factor(), most_shading);
      }
    }
  }
  EXPECT_GT(hits, 3000);
  EXPECT_LE(others, most_others);
}

TEST(Instances, AreSeenAsCopiesAre) {
  expect_seen_as_copies_are<double>(0, 1e-12);
  expect_seen_as_copies_are<float>(2, 1e-5);
}

TEST(Instances, AThousandShareOneMesh) {
  const PreparedScene<double> prepared = prepare_scene(instances_alone(1, 1000), {});
  ASSERT_EQ(prepared.meshes.size(), 1U);
  EXPECT_EQ(prepared.meshes[0].triangles.size(), 8U);
  EXPECT_TRUE(surfaces_of<TriangleSurface>(prepared).empty());
  EXPECT_EQ(surfaces_of<InstanceSurface>(prepared).size(), 1000U);
}

TEST(Instances, EachTriangleOfEachHasANumberOfItsOwn) {
  const PreparedScene<double> prepared = prepare_scene(instances_alone(2, 5), {});
  std::set<std::pair<std::uint32_t, std::uint32_t>> identities;
  for (std::uint32_t index = 0; index < 5 * 8; ++index) {
    EXPECT_EQ(instance_of_hit(prepared, index), index / 8);
    const SurfaceIdentity identity = triangle_of_hit(prepared, index).identity;
    EXPECT_EQ(identity.object, identity.order / 8) << "as if each had a copy of the mesh";
    identities.emplace(identity.object, identity.order);
  }
  EXPECT_EQ(identities.size(), 5U * 8);
}

/// Of an instance before the observer, places on edges between two sides that both face him, in his coordinates.
std::vector<glm::dvec3> places_on_inner_edges(const MeshInstance& instance, Random& random) {
  const Mesh& mesh = instance.of->mesh;
  const auto vertex = [&](std::uint32_t k) { return rounded(instance.map.point(exactly(mesh.vertices[k]))); };
  const glm::dvec3 middle = rounded(instance.map.point(exactly(instance.of->box.center())));
  const auto faces_observer = [&](const std::array<std::uint32_t, 3>& triangle) {
    const glm::dvec3 a = vertex(triangle[0]);
    glm::dvec3 normal = cross(vertex(triangle[1]) - a, vertex(triangle[2]) - a);
    if (dot(normal, a - middle) < 0) normal = -normal;
    return dot(normal, a) < -0.2 * std::sqrt(dot(normal, normal) * dot(a, a));
  };
  std::vector<glm::dvec3> places;
  for (const auto& one : mesh.triangles) {
    for (const auto& other : mesh.triangles) {
      std::vector<std::uint32_t> shared;
      for (const std::uint32_t k : one) {
        if (std::find(other.begin(), other.end(), k) != other.end()) shared.push_back(k);
      }
      if (shared.size() != 2 || !faces_observer(one) || !faces_observer(other)) continue;
      for (int k = 0; k < 8; ++k) {
        const double part = random.uniform(0.25, 0.75);
        places.push_back(vertex(shared[0]) * part + vertex(shared[1]) * (1 - part));
      }
    }
  }
  return places;
}

/// Neighbours compute a shared edge from the same numbers, in the mesh's coordinates too.
TEST(Instances, NoRayRunsBetweenTheirTriangles) {
  for_every_format([&]<class Scalar>() {
    Random random(7);
    std::mt19937_64 engine(8);
    int aimed = 0;
    for (int k = 0; k < 60; ++k) {
      Scene scene = empty_scene(1, 1, 1);
      const MeshInstance instance =
          random_instance(engine, octahedron(), {6, random.uniform(-2, 2), random.uniform(-2, 2)});
      scene.objects = {object(instance)};
      const auto intersector = make_intersector(scene, format_of<Scalar>());
      const RoundToFormat round(format_of<Scalar>());
      for (const glm::dvec3& place : places_on_inner_edges(instance, random)) {
        Work work;
        const glm::dvec3 along(1, round(place.y / place.x), round(place.z / place.x));
        ASSERT_EQ(intersector->intersect(along, work).seen.object, 0U) << k;
        ++aimed;
      }
    }
    EXPECT_GT(aimed, 500);
  });
}

/// A ray that meets no box of the instance costs its test alone; one through its middle at most its hierarchy.
TEST(Instances, WorkIsThatOfTheirMesh) {
  Scene scene = empty_scene(1, 1, 1);
  const auto mesh = octahedron();
  scene.objects.push_back(
      object(MeshInstance{mesh, {}}.transformed(AffineMap::translation(glm::dvec3(9, 0, 0) - mesh->box.center()))));
  const SceneIntersector<double> intersector(scene);
  Work through;
  EXPECT_EQ(intersector.intersect({1, 0.01, 0.02}, through).seen.object, 0U);
  EXPECT_EQ(through.surface_tests[index_of_kind<InstanceSurface>], 1U);
  EXPECT_GE(through.surface_tests[index_of_kind<TriangleSurface>], 1U);
  EXPECT_LE(through.surface_tests[index_of_kind<TriangleSurface>], 8U);
  EXPECT_GE(through.box_tests, 1U);
  Work beside;
  EXPECT_EQ(intersector.intersect({1, 0.07, 0.07}, beside).seen.object, no_object);
  EXPECT_EQ(beside.surface_tests[index_of_kind<InstanceSurface>], 1U) << "alone, it has no box but those of its mesh";
  EXPECT_LT(beside.surface_tests[index_of_kind<TriangleSurface>],
            through.surface_tests[index_of_kind<TriangleSurface>]);
}

}  // namespace
}  // namespace pyrasim
