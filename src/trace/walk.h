// SPDX-License-Identifier: Apache-2.0
// Finds the nearest surface over planes and a bounding volume hierarchy, and its shading; in any number format.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>

#include "pyramid/sample.h"
#include "trace/box_test.h"
#include "trace/hierarchy_builder.h"
#include "trace/plane.h"
#include "trace/prepared_scene.h"
#include "trace/ray.h"
#include "trace/sphere.h"
#include "trace/triangle.h"

namespace pyrasim {

template <class Scalar>
Scalar flat_side(const FlatShading<Scalar>& shading, const Vector<Scalar>& direction) {
  return dot(shading.normal, direction) < Scalar(0) ? shading.front : shading.back;
}

/// One ray on its way through a scene, and the nearest surface that it met so far.
template <class Scalar>
class Walk {
 public:
  Walk(const PreparedScene<Scalar>& scene, const Vector<Scalar>& view_vector, Work& work)
      : scene_(scene), ray_(view_vector), work_(work) {}

  void test_planes() {
    for (std::uint32_t k = 0; k < scene_.planes.size(); ++k) {
      const auto& plane = scene_.planes[k];
      offer(intersect_plane(plane, ray_.direction), plane.identity.order, SurfaceKind::plane, k);
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
      while (here.met == 0 || here.node->boxes.depth[child = lowest_bit(here.met)] > depth_limit_) {
        if (top == stack.data()) return;
        here = *--top;
      }
      here.met &= here.met - 1;
      current = here.node->child[child];
    }
  }

  Sample shade() const {
    switch (kind_) {
      case SurfaceKind::plane: {
        if (index_ == no_object) return {};
        const auto& plane = scene_.planes[index_];
        return {plane.identity.object, static_cast<double>(flat_side(plane.shading, ray_.direction))};
      }
      case SurfaceKind::triangle:
        return {scene_.triangles[index_].identity.object,
                static_cast<double>(flat_side(scene_.triangle_shading[index_], ray_.direction))};
      default:
        return shade_sphere(scene_.spheres[index_]);
    }
  }

 private:
  using Node = typename PreparedScene<Scalar>::Node;
  using Leaf = typename PreparedScene<Scalar>::Leaf;

  static std::size_t lowest_bit(unsigned bits) { return static_cast<std::size_t>(std::countr_zero(bits)); }

  [[gnu::always_inline]] void test_leaf(const Leaf& leaf) {
    for (std::uint32_t k = leaf.first_sphere; k < leaf.first_sphere + leaf.spheres; ++k) {
      const auto& sphere = scene_.spheres[k];
      offer(intersect_sphere(sphere, ray_.direction, ray_.inverse_length_squared), sphere.identity.order,
            SurfaceKind::sphere, k);
    }
    count(SurfaceKind::sphere, leaf.spheres);
    if (leaf.triangles == 0) return;
    const TriangleShear<Scalar> shear(ray_.direction);
    for (std::uint32_t k = leaf.first_triangle; k < leaf.first_triangle + leaf.triangles; ++k) {
      const auto& triangle = scene_.triangles[k];
      offer(intersect_triangle(triangle, shear), triangle.identity.order, SurfaceKind::triangle, k);
    }
    count(SurfaceKind::triangle, leaf.triangles);
  }

  void offer(Scalar t, std::uint32_t order, SurfaceKind kind, std::uint32_t index) {
    if (!nearest_.improved_by(t, order)) return;
    nearest_ = {t, order};
    depth_limit_ = t * ray_.direction.x;
    kind_ = kind;
    index_ = index;
  }

  void count(SurfaceKind kind, std::uint64_t tests) { work_.surface_tests[static_cast<std::size_t>(kind)] += tests; }

  /// Lambert's cosine law on the side that the ray meets: ambient + (1 - ambient) max(0, -n . l); a cosine beyond 1, or
  /// none at all, is a narrow format's mistake.
  Sample shade_sphere(const SphereSurface<Scalar>& sphere) const {
    if (!scene_.lit) return {sphere.identity.object, 1.0};
    const Vector<Scalar> outward = ray_.direction * nearest_.t - sphere.center;
    const Scalar side = sphere.power < Scalar(0) ? -sphere.radius : sphere.radius;
    const Scalar cosine = dot(outward, scene_.towards_light) / side;
    const Scalar lit = std::min(std::max(Scalar(0), cosine), Scalar(1));
    return {sphere.identity.object, static_cast<double>(scene_.ambient + (Scalar(1) - scene_.ambient) * lit)};
  }

  const PreparedScene<Scalar>& scene_;
  const ViewRay<Scalar> ray_;
  Work& work_;
  Nearest<Scalar> nearest_{std::numeric_limits<Scalar>::infinity(), no_object};
  Scalar depth_limit_ = std::numeric_limits<Scalar>::infinity();  ///< boxes that begin deeper hold nothing nearer
  SurfaceKind kind_ = SurfaceKind::plane;
  std::uint32_t index_ = no_object;  ///< among the surfaces of its kind; no_object without a hit
};

}  // namespace pyrasim
