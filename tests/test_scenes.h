// SPDX-License-Identifier: Apache-2.0
// Scenes that tests make by hand or by a seed. The camera stands in the observer's own frame: x forward, y up, z right.
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <memory>
#include <random>
#include <utility>

#include "scene/scene.h"

namespace pyrasim {

/// A screen at distance 1 with square pixels.
inline Scene empty_scene(int columns, int rows, double pixel) {
  Scene scene;
  scene.camera.screen = {columns, rows, 1.0, pixel, pixel};
  scene.background = {0.125, 0.25, 0.5};
  return scene;
}

inline Object object(SceneSurface surface, const glm::dvec3& color = {1, 1, 1}) {
  return {"", color, std::move(surface)};
}

inline glm::dvec3 random_vector(std::mt19937_64& random, const glm::dvec3& lower, const glm::dvec3& upper) {
  glm::dvec3 v;
  for (int k = 0; k < 3; ++k) v[k] = std::uniform_real_distribution<double>(lower[k], upper[k])(random);
  return v;
}

struct RandomContents {
  int spheres = 0;
  int triangles = 0;
  int planes = 0;
  int discs = 0;
  int boxes = 0;
  int quadrics = 0;  ///< each kind of them in turn
  int tori = 0;
  int instances = 0;  ///< of one mesh
};

/// A paraboloid, a hyperboloid of one sheet or two, or an ellipsoid about `middle`, within a box of half its size.
inline Quadric random_general_quadric(std::mt19937_64& random, const glm::dvec3& middle, const glm::dvec3& size) {
  const glm::dvec3 turned = random_vector(random, glm::dvec3(-0.5), glm::dvec3(0.5));
  const bool paraboloid = random() % 3 == 0;
  const double last = paraboloid ? 0 : random() % 2 == 0 ? 1 : -1;
  Quadric::Coefficients q{1, 1, last, turned.x, 0, 0, 0, 0, paraboloid ? 1.0 : 0.0, random() % 2 == 0 ? -0.1 : 0.1};
  q.constant +=
      middle.x * (middle.x + q.xy * middle.y) + middle.y * middle.y + last * middle.z * middle.z - q.z * middle.z;
  q.x = -2 * middle.x - q.xy * middle.y;
  q.y = -2 * middle.y - q.xy * middle.x;
  q.z -= 2 * last * middle.z;
  Quadric quadric{q, {}, size.y > 0.6};
  for (int axis = 0; axis < 3; ++axis) {
    for (const double outward : {-1.0, 1.0}) {
      glm::dvec3 normal(0);
      normal[axis] = outward;
      quadric.clip.push_back({normal, outward * middle[axis] + size[axis]});
    }
  }
  if (size.x > 0.6) quadric.clip.push_back({turned, turned.x * middle.x + turned.y * middle.y + turned.z * middle.z});
  return quadric;
}

/// A quadric of any kind about `middle`; `which` is the kind.
inline SceneSurface random_quadric(std::mt19937_64& random, const glm::dvec3& middle, int which) {
  const glm::dvec3 size = random_vector(random, glm::dvec3(0.05), glm::dvec3(1.2));
  const AxisSegment axis{middle, middle + random_vector(random, glm::dvec3(-1), glm::dvec3(1))};
  switch (which % 5) {
    case 0:
      return Ellipsoid{middle, size};
    case 1:
      return Cylinder{axis, size.x / 2, size.y > 0.6};
    case 2:
      return Cone{axis, size.x, 0, size.y > 0.6};
    case 3:
      return Cone{axis, size.x / 2, size.z, size.y > 0.6};
    default:
      return random_general_quadric(random, middle, size);
  }
}

/// Eight triangles, closed, about a place beside the mesh's origin, with texture coordinates, and normals if smooth.
inline std::shared_ptr<const InstancedMesh> octahedron(bool smooth = true) {
  const glm::dvec3 middle(0.25, 1, -0.5);
  Mesh mesh;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-0.75, 0.5}) {
      glm::dvec3 vertex = middle;
      vertex[axis] += side;
      mesh.vertices.push_back(vertex);
    }
  }
  for (std::uint32_t k = 0; k < 8; ++k) mesh.triangles.push_back({k & 1U, 2 + (k >> 1U & 1U), 4 + (k >> 2U)});
  mesh.places = {{{0, 0}, {2, 1}, {1, -1}, {0.5, 3}, {4, 0.25}, {-1, 1}}, mesh.triangles};
  if (smooth) {
    for (const glm::dvec3& vertex : mesh.vertices) mesh.normals.values.push_back(glm::normalize(vertex - middle));
    mesh.normals.corners = mesh.triangles;
  }
  return std::make_shared<const InstancedMesh>(mesh);
}

/// Turned about an axis, stretched by up to 4 times as much along one axis as along another, its middle at `place`.
inline MeshInstance random_instance(std::mt19937_64& random, const std::shared_ptr<const InstancedMesh>& mesh,
                                    const glm::dvec3& place) {
  const auto factor = [&] {
    return std::exp2(std::uniform_real_distribution<double>(-2, 0)(random)) * (random() % 4 == 0 ? -1.5 : 1.5);
  };
  AffineMap map = AffineMap::translation(-mesh->box.center());
  map = AffineMap::scaling({factor(), factor(), factor()}).after(map);
  map = AffineMap::rotation(random_vector(random, glm::dvec3(-1), glm::dvec3(1)), static_cast<double>(random() % 360))
            .after(map);
  return MeshInstance{mesh, {}}.transformed(AffineMap::translation(place).after(map));
}

/// Surfaces of mixed sizes scattered in front of the observer, in a random order, lit.
inline Scene random_scene(std::uint64_t seed, const RandomContents& contents, int columns, int rows) {
  std::mt19937_64 random(seed);
  Scene scene = empty_scene(columns, rows, 1.2 / columns);
  scene.light = SingleLight{0.25, {0.6, -1, 0.4}};
  const auto color = [&] { return random_vector(random, {0, 0, 0}, {1, 1, 1}); };
  const auto place = [&] { return random_vector(random, {3, -3, -4}, {12, 3, 4}); };
  for (int k = 0; k < contents.spheres; ++k) {
    const double radius = std::uniform_real_distribution<double>(0.05, 1.2)(random);
    scene.objects.push_back(object(Sphere{place(), radius}, color()));
  }
  for (int k = 0; k < contents.triangles; ++k) {
    const glm::dvec3 a = place();
    const auto near = [&] { return a + random_vector(random, glm::dvec3(-2), glm::dvec3(2)); };
    const glm::dvec3 b = near();
    scene.objects.push_back(object(Triangle{{a, b, near()}}, color()));
  }
  for (int k = 0; k < contents.planes; ++k) {
    const glm::dvec3 normal = random_vector(random, glm::dvec3(-1), glm::dvec3(1));
    const double offset = std::uniform_real_distribution<double>(-15, -6)(random);
    scene.objects.push_back(object(Plane{normal, offset}, color()));
  }
  for (int k = 0; k < contents.discs; ++k) {
    const glm::dvec3 center = place();
    const double radius = std::uniform_real_distribution<double>(0.05, 1.5)(random);
    scene.objects.push_back(
        object(Disc{center, random_vector(random, glm::dvec3(-1), glm::dvec3(1)), radius}, color()));
  }
  for (int k = 0; k < contents.boxes; ++k) {
    const glm::dvec3 corner = place();
    const glm::dvec3 size = random_vector(random, glm::dvec3(0.05), glm::dvec3(1.2));
    scene.objects.push_back(object(Box{corner, corner + size}, color()));
  }
  for (int k = 0; k < contents.quadrics; ++k)
    scene.objects.push_back(object(random_quadric(random, place(), k), color()));
  for (int k = 0; k < contents.tori; ++k) {
    const glm::dvec3 center = place();
    const glm::dvec3 axis = random_vector(random, glm::dvec3(-1), glm::dvec3(1));
    const double major = std::uniform_real_distribution<double>(0.1, 1.2)(random);
    const double minor = major * std::uniform_real_distribution<double>(0.1, 1)(random);
    scene.objects.push_back(object(Torus{center, axis, major, minor}, color()));
  }
  const auto mesh = octahedron(seed % 2 == 0);
  for (int k = 0; k < contents.instances; ++k) {
    scene.objects.push_back(object(random_instance(random, mesh, place()), color()));
  }
  for (std::size_t k = scene.objects.size(); k > 1; --k) std::swap(scene.objects[k - 1], scene.objects[random() % k]);
  return scene;
}

/// Under a list of lights instead, most of them with shadows, and one object in four casts none.
inline Scene under_lights(Scene scene, std::mt19937_64& random) {
  const auto color = [&] { return random_vector(random, {0, 0, 0}, {1, 1, 1}); };
  scene.light.reset();
  scene.lights = std::vector<Light>{AmbientLight{{0.1, 0.1, 0.2}}};
  for (std::uint64_t k = random() % 3 + 1; k > 0; --k) {
    const bool shadow = random() % 4 != 0;
    if (random() % 2 == 0) {
      scene.lights->emplace_back(DirectionalLight{random_vector(random, {-1, -2, -1}, {1, 0, 1}), color(), shadow});
    } else {
      scene.lights->emplace_back(PointLight{random_vector(random, {-2, -3, -4}, {12, 6, 4}), color() * 5.0,
                                            static_cast<Falloff>(random() % 3), shadow});
    }
  }
  for (Object& object : scene.objects) object.casts_shadow = random() % 4 != 0;
  return scene;
}

/// Half of the objects with a pattern.
inline Scene with_textures(Scene scene, std::mt19937_64& random) {
  const auto color = [&] { return random_vector(random, {0, 0, 0}, {1, 1, 1}); };
  const auto number = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (Object& object : scene.objects) {
    if (random() % 2 == 0) continue;
    const Texture texture{.pattern = random() % 2 == 0 ? Pattern::checker : Pattern::stripes,
                          .colors = {color(), color()},
                          .scale = {number(0.05, 1), number(0.05, 1)},
                          .shift = {number(-1, 1), number(-1, 1)},
                          .turn = number(0, 360)};
    object.texture = std::make_shared<const ObjectTexture>(
        ObjectTexture{texture, std::make_shared<const SceneSurface>(object.surface), AffineMap()});
  }
  return scene;
}

}  // namespace pyrasim
