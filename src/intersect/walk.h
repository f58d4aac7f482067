// SPDX-License-Identifier: Apache-2.0
// Finds the nearest surface over planes and a bounding volume hierarchy, and its shading; in any number format.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>

#include "intersect/box_test.h"
#include "intersect/hierarchy_builder.h"
#include "intersect/plane.h"
#include "intersect/prepared_scene.h"
#include "intersect/ray.h"
#include "intersect/sphere.h"
#include "intersect/standing.h"
#include "intersect/triangle.h"
#include "raster/sample.h"

namespace pyrasim {

template <class Scalar>
Scalar flat_side(const FlatShading<Scalar>& shading, const Vector<Scalar>& direction) {
  return dot(shading.normal, direction) < Scalar(0) ? shading.front : shading.back;
}

/// What the ray sees of a surface that it met.
///
/// Lambert's cosine law on the side that the ray meets: ambient + (1 - ambient) max(0, -n . l); a cosine beyond 1, or
/// none at all, is a narrow format's mistake.
template <class Scalar>
[[gnu::always_inline]] inline Sample shade_sphere(const PreparedScene<Scalar>& scene, const Vector<Scalar>& direction,
                                                  const Hit<Scalar>& hit) {
  const SphereSurface<Scalar>& sphere = scene.spheres[hit.index];
  if (!scene.lit) return {sphere.identity.object, 1.0};
  const Vector<Scalar> outward = direction * hit.t - sphere.center;
  const Scalar side = sphere.power < Scalar(0) ? -sphere.radius : sphere.radius;
  const Scalar cosine = dot(outward, scene.towards_light) / side;
  const Scalar lit = std::min(std::max(Scalar(0), cosine), Scalar(1));
  return {sphere.identity.object, static_cast<double>(scene.ambient + (Scalar(1) - scene.ambient) * lit)};
}

template <class Scalar>
[[gnu::always_inline]] inline Sample shade(const PreparedScene<Scalar>& scene, const Vector<Scalar>& direction,
                                           const Hit<Scalar>& hit) {
  switch (hit.kind) {
    case SurfaceKind::plane: {
      if (hit.index == no_object) return {};
      const auto& plane = scene.planes[hit.index];
      return {plane.identity.object, static_cast<double>(flat_side(plane.shading, direction))};
    }
    case SurfaceKind::triangle:
      return {scene.triangles[hit.index].identity.object,
              static_cast<double>(flat_side(scene.triangle_shading[hit.index], direction))};
    default:
      return shade_sphere(scene, direction, hit);
  }
}

/// One ray on its way through a scene. What it meets enters `Standing`, one of standing.h.
template <class Scalar, class Standing>
class Walk {
 public:
  Walk(const PreparedScene<Scalar>& scene, const Vector<Scalar>& view_vector, Work& work, Standing& standing)
      : scene_(scene), ray_(view_vector), work_(work), standing_(standing) {}

  void test_planes() {
    for (std::uint32_t k = 0; k < scene_.planes.size(); ++k) {
      const auto& plane = scene_.planes[k];
      const Scalar t = intersect_plane(plane, ray_.direction);
      const auto depth = static_cast<double>(t);
      const double squared_length = plane.squared_length * static_cast<double>(ray_.inverse_length_squared);
      offer({t, SurfaceKind::plane, k}, depth * depth <= squared_length ? plane.relative_error : infinity);
    }
    count(SurfaceKind::plane, scene_.planes.size());
  }

  /// The nearest child first; the others wait, and are dropped if a hit before their box turns up meanwhile.
  /// Inlined by force: kept in registers, the state of a walk costs a third less time than in memory.
  [[gnu::always_inline]] void traverse(std::int32_t current) {
    struct Pending {
      const Node* node;
      unsigned met;  ///< the children that wait
    };
    std::array<Pending, max_hierarchy_depth> stack;
    Pending* top = stack.data();
    const auto begins = [](const Pending& pending, std::size_t child) {
      return static_cast<DepthLimit<Scalar>>(pending.node->boxes.depth[child]);
    };
    Pending here{nullptr, 0};
    for (;;) {
      if (current >= 0) {
        if (here.met != 0) *top++ = here;
        here.node = &scene_.nodes[static_cast<std::size_t>(current)];
        here.met = met_boxes(here.node->boxes, ray_, depth_limit_);
        work_.box_tests += here.node->children;
      } else {
        test_leaf(scene_.leaves[static_cast<std::size_t>(~static_cast<std::int64_t>(current))]);
      }
      std::size_t child = 0;
      while (here.met == 0 || begins(here, child = lowest_bit(here.met)) > depth_limit_) {
        if (top == stack.data()) return;
        here = *--top;
      }
      here.met &= here.met - 1;
      current = here.node->child[child];
    }
  }

 private:
  using Node = typename PreparedScene<Scalar>::Node;
  using Leaf = typename PreparedScene<Scalar>::Leaf;
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  static std::size_t lowest_bit(unsigned bits) { return static_cast<std::size_t>(std::countr_zero(bits)); }

  [[gnu::always_inline]] void test_leaf(const Leaf& leaf) {
    for (std::uint32_t k = leaf.first_sphere; k < leaf.first_sphere + leaf.spheres; ++k) {
      const Scalar t = intersect_sphere(scene_.spheres[k], ray_.direction, ray_.inverse_length_squared);
      offer({t, SurfaceKind::sphere, k}, leaf.relative_error);
    }
    count(SurfaceKind::sphere, leaf.spheres);
    if (leaf.triangles == 0) return;
    const TriangleShear<Scalar> shear(ray_.direction);
    for (std::uint32_t k = leaf.first_triangle; k < leaf.first_triangle + leaf.triangles; ++k) {
      offer({intersect_triangle(scene_.triangles[k], shear), SurfaceKind::triangle, k}, leaf.relative_error);
    }
    count(SurfaceKind::triangle, leaf.triangles);
  }

  void offer(const Hit<Scalar>& hit, double relative_error) {
    if (!(hit.t > Scalar(0)) || !standing_.enter(hit, relative_error)) return;
    depth_limit_ = static_cast<DepthLimit<Scalar>>(standing_.highest() * static_cast<double>(ray_.direction.x));
  }

  void count(SurfaceKind kind, std::uint64_t tests) { work_.surface_tests[static_cast<std::size_t>(kind)] += tests; }

  const PreparedScene<Scalar>& scene_;
  const ViewRay<Scalar> ray_;
  Work& work_;
  Standing& standing_;
  DepthLimit<Scalar> depth_limit_ = std::numeric_limits<DepthLimit<Scalar>>::infinity();  ///< boxes beyond are behind
};

/// What the ray sees among the planes, and the bounded surfaces below `root` (as Node::child). `work` becomes `before`
/// and the tests made.
template <class Scalar>
Sample nearest_of_close_hits(const PreparedScene<Scalar>& scene, const Vector<Scalar>& view_vector, std::int32_t root,
                             const Work& before, Work& work) {
  work = before;
  CloseStanding<Scalar> standing(scene, view_vector);
  Walk<Scalar, CloseStanding<Scalar>> walk(scene, view_vector, work, standing);
  do {
    walk.test_planes();
    walk.traverse(root);
  } while (standing.repeats());
  return shade(scene, view_vector, standing.leader());
}

extern template Sample nearest_of_close_hits(const PreparedScene<double>&, const Vector<double>&, std::int32_t,
                                             const Work&, Work&);

/// The same; adds the tests made to `work`. Nearly all rays of nearly all scenes meet surfaces that lie clearly apart;
/// whoever does not starts again. That pays in double, where errors are so small that hardly a box lies between what is
/// coarsely known of them and what is known of a hit.
template <class Scalar>
[[gnu::always_inline]] inline Sample nearest_hit(const PreparedScene<Scalar>& scene, const Vector<Scalar>& view_vector,
                                                 std::int32_t root, Work& work) {
  const Work before = work;
  if constexpr (std::is_same_v<Scalar, double>) {
    ClearStanding<Scalar> standing;
    Walk<Scalar, ClearStanding<Scalar>> walk(scene, view_vector, work, standing);
    walk.test_planes();
    walk.traverse(root);
    if (!standing.undecided()) [[likely]]
      return shade(scene, view_vector, standing.leader());
  }
  return nearest_of_close_hits(scene, view_vector, root, before, work);
}

}  // namespace pyrasim
