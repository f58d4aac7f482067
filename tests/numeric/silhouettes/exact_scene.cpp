// SPDX-License-Identifier: Apache-2.0
#include "exact_scene.h"

#include <algorithm>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <limits>
#include <map>
#include <stdexcept>

#include "../../test_scenes.h"

namespace pyrasim::silhouettes {
namespace {

void require(bool holds, const char* what) {
  if (!holds) throw std::logic_error(what);
}

}  // namespace

ExactScene::ExactScene(const Scene& scene) : prepared_(prepare_scene(scene, {})) {
  const Screen& screen = scene.camera.screen;
  require(screen.rows * screen.dy <= 2 * screen.dx && screen.columns * screen.dz <= 2 * screen.dx,
          "error bounds are for slopes of at most 1");
  for (const auto& sphere : surfaces_of<SphereSurface>(prepared_)) {
    require(sphere.power > 0, "error bounds are for an observer outside of spheres");
  }
  for (const auto& box : surfaces_of<BoxSurface>(prepared_)) {
    const bool outside = std::any_of(box.slabs.begin(), box.slabs.end(),
                                     [](const auto& slab) { return slab.lower > 0 || slab.upper < 0; });
    require(outside, "error bounds are for an observer outside of boxes");
  }
  for (const auto& torus : surfaces_of<TorusSurface>(prepared_)) {
    require(torus.side > 0, "error bounds are for an observer outside of tori");
  }
  find_facets();
  find_neighbors();
}

void ExactScene::find_facets() {
  for (const auto& triangle : surfaces_of<TriangleSurface>(prepared_)) facets_.push_back({.triangle = triangle});
  for (const auto& instance : surfaces_of<InstanceSurface>(prepared_)) {
    const auto& triangles = prepared_.meshes[instance.mesh].triangles;
    for (std::uint32_t place = 0; place < triangles.size(); ++place) {
      Facet facet{.triangle = triangles[place], .instance = &instance, .place = place};
      facet.triangle.identity = {instance.identity.object, instance.identity.order + triangles[place].identity.order};
      facets_.push_back(facet);
    }
  }
  for (Facet& facet : facets_) find_extent(facet);
}

/// An instance's numbers err by roundings of lengths in its coordinates, which are shorter than the observer's by as
/// much as it is uneven, and of its farthest corner's.
void ExactScene::find_extent(Facet& facet) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  facet.extent = {infinity, -infinity, infinity, -infinity};
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& [x, y, z] : facet.triangle.vertices) {
    glm::dvec3 p(x, y, z);
    if (facet.instance != nullptr) {
      const auto& [a, b, c] = facet.instance->rows;
      p = glm::inverse(glm::transpose(glm::dmat3(a, b, c))) * (p * facet.instance->scale - facet.instance->origin);
    }
    require(p.x > 0, "error bounds are for triangles before the observer");
    nearest = std::min(nearest, p.x);
    facet.extent.lower_y = std::min(facet.extent.lower_y, static_cast<float>(p.y / p.x));
    facet.extent.upper_y = std::max(facet.extent.upper_y, static_cast<float>(p.y / p.x));
    facet.extent.lower_z = std::min(facet.extent.lower_z, static_cast<float>(p.z / p.x));
    facet.extent.upper_z = std::max(facet.extent.upper_z, static_cast<float>(p.z / p.x));
  }
  nearest_vertex_ = std::min(nearest_vertex_, nearest);
  facet.doubt = facet.instance == nullptr
                    ? 1.0F
                    : static_cast<float>(2 * unevenness(*facet.instance) * reach(*facet.instance) / nearest);
}

void ExactScene::find_neighbors() {
  using Vertex = std::array<double, 3>;
  std::map<Vertex, std::uint32_t> numbers;
  struct Side {
    std::array<std::uint32_t, 3> edge;  ///< object, then its vertices, the smaller number first
    bool backwards;
    std::uint32_t facet, opposite;
  };
  std::vector<Side> sides;
  for (std::uint32_t k = 0; k < facets_.size(); ++k) {
    std::array<std::uint32_t, 3> vertices{};
    for (std::size_t i = 0; i < 3; ++i) {
      vertices[i] = numbers.try_emplace(facets_[k].triangle.vertices[i], numbers.size()).first->second;
    }
    for (std::uint32_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::pair(vertices[(i + 1) % 3], vertices[(i + 2) % 3]);
      sides.push_back(
          {{facets_[k].triangle.identity.object, std::min(low, high), std::max(low, high)}, low > high, k, i});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.edge < b.edge; });
  neighbors_.resize(facets_.size());
  for (std::size_t first = 0, last = 0; first < sides.size(); first = last) {
    while (last < sides.size() && sides[last].edge == sides[first].edge) ++last;
    if (last - first != 2) continue;
    const Side& a = sides[first];
    const Side& b = sides[first + 1];
    const bool turned = a.backwards == b.backwards;
    neighbors_[a.facet][a.opposite] = {static_cast<std::int32_t>(b.facet), turned};
    neighbors_[b.facet][b.opposite] = {static_cast<std::int32_t>(a.facet), turned};
  }
}

int ExactScene::exponent_of(const NumberFormat& format) {
  Scene scene = empty_scene(1, 1, 1);
  scene.objects.push_back(object(Sphere{{2, 0, 0}, 1}));
  return prepare_scene(scene, format).exponent - prepare_scene(scene, {}).exponent;
}

}  // namespace pyrasim::silhouettes
