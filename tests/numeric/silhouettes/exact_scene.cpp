// SPDX-License-Identifier: Apache-2.0
#include "exact_scene.h"

#include <algorithm>
#include <cmath>
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
  require(surfaces_of<InstanceSurface>(prepared_).empty(), "there are no error bounds for instances here");
  find_extents();
  find_neighbors();
}

void ExactScene::find_extents() {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  nearest_vertex_ = std::numeric_limits<double>::infinity();
  for (const auto& triangle : triangles()) {
    Extent extent{infinity, -infinity, infinity, -infinity};
    for (const auto& [x, y, z] : triangle.vertices) {
      require(x > 0, "error bounds are for triangles before the observer");
      nearest_vertex_ = std::min(nearest_vertex_, x);
      extent.lower_y = std::min(extent.lower_y, static_cast<float>(y / x));
      extent.upper_y = std::max(extent.upper_y, static_cast<float>(y / x));
      extent.lower_z = std::min(extent.lower_z, static_cast<float>(z / x));
      extent.upper_z = std::max(extent.upper_z, static_cast<float>(z / x));
    }
    extents_.push_back(extent);
  }
}

void ExactScene::find_neighbors() {
  using Vertex = std::array<double, 3>;
  std::map<Vertex, std::uint32_t> numbers;
  struct Side {
    std::array<std::uint32_t, 3> edge;  ///< object, then its vertices, the smaller number first
    bool backwards;
    std::uint32_t triangle, opposite;
  };
  std::vector<Side> sides;
  for (std::uint32_t k = 0; k < triangles().size(); ++k) {
    std::array<std::uint32_t, 3> vertices{};
    for (std::size_t i = 0; i < 3; ++i) {
      vertices[i] = numbers.try_emplace(triangles()[k].vertices[i], numbers.size()).first->second;
    }
    for (std::uint32_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::pair(vertices[(i + 1) % 3], vertices[(i + 2) % 3]);
      sides.push_back({{triangles()[k].identity.object, std::min(low, high), std::max(low, high)}, low > high, k, i});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.edge < b.edge; });
  neighbors_.resize(triangles().size());
  for (std::size_t first = 0, last = 0; first < sides.size(); first = last) {
    while (last < sides.size() && sides[last].edge == sides[first].edge) ++last;
    if (last - first != 2) continue;
    const Side& a = sides[first];
    const Side& b = sides[first + 1];
    const bool turned = a.backwards == b.backwards;
    neighbors_[a.triangle][a.opposite] = {static_cast<std::int32_t>(b.triangle), turned};
    neighbors_[b.triangle][b.opposite] = {static_cast<std::int32_t>(a.triangle), turned};
  }
}

int ExactScene::exponent_of(const NumberFormat& format) {
  Scene scene = empty_scene(1, 1, 1);
  scene.objects.push_back(object(Sphere{{2, 0, 0}, 1}));
  return prepare_scene(scene, format).exponent - prepare_scene(scene, {}).exponent;
}

}  // namespace pyrasim::silhouettes
