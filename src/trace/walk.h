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
#include "trace/contest.h"
#include "trace/hierarchy_builder.h"
#include "trace/plane.h"
#include "trace/prepared_scene.h"
#include "trace/ray.h"
#include "trace/rounded_scene.h"
#include "trace/sphere.h"
#include "trace/triangle.h"

namespace pyrasim {

template <class Scalar>
Scalar flat_side(const FlatShading<Scalar>& shading, const Vector<Scalar>& direction) {
  return dot(shading.normal, direction) < Scalar(0) ? shading.front : shading.back;
}

/// A surface that a ray met: where, and which.
template <class Scalar>
struct Hit {
  Scalar t;
  SurfaceKind kind;
  std::uint32_t index;  ///< among the surfaces of its kind; no_object without a hit
};

template <class Scalar>
SurfaceIdentity identity_of(const PreparedScene<Scalar>& scene, const Hit<Scalar>& hit) {
  if (hit.kind == SurfaceKind::sphere) return scene.spheres[hit.index].identity;
  if (hit.kind == SurfaceKind::plane) return scene.planes[hit.index].identity;
  return scene.triangles[hit.index].identity;
}

template <class Scalar>
DistanceRange range_of(const PreparedScene<Scalar>& scene, const Vector<Scalar>& direction, const Hit<Scalar>& hit) {
  const auto range = [&](const auto& surface) {
    return distance_range(in_double(surface), in_double(direction), static_cast<double>(hit.t), scene.rounding);
  };
  if (hit.kind == SurfaceKind::sphere) return range(scene.spheres[hit.index]);
  if (hit.kind == SurfaceKind::plane) return range(scene.planes[hit.index]);
  return range(scene.triangles[hit.index]);
}

/// Enters a hit, whether it leads now; before it the one that leads, if that has not entered yet.
/// Out of line, and what it takes comes by value: a walk stays in registers.
template <class Scalar>
[[gnu::noinline]] bool contend(Contest& contest, const PreparedScene<Scalar>& scene, Vector<Scalar> direction,
                               Hit<Scalar> leader, bool leader_entered, Hit<Scalar> hit) {
  if (!leader_entered) contest.open(range_of(scene, direction, leader), identity_of(scene, leader).order);
  return contest.enter(range_of(scene, direction, hit), identity_of(scene, hit).order);
}

/// One ray on its way through a scene, and the surface that leads so far (decision D7).
///
/// How far a hit's t may err is known coarsely before there is a ray, as a part of t. As long as such coarse ranges do
/// not overlap, the nearer hit leads, and nothing else is computed; where they do, the hits enter a contest.
template <class Scalar>
class Walk {
 public:
  Walk(const PreparedScene<Scalar>& scene, const Vector<Scalar>& view_vector, Work& work, Contest& contest)
      : scene_(scene), ray_(view_vector), work_(work), contest_(contest) {}

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

  /// Once all surfaces have been tested: whether that has to be done again.
  bool repeats() {
    if (!entered_ || !contest_.in_doubt()) return false;
    contest_.repeat();
    lowest_ = 0;
    leader_.index = no_object;
    return true;
  }

  Sample shade() const {
    if (leader_.index == no_object) return {};
    const std::uint32_t object = identity_of(scene_, leader_).object;
    switch (leader_.kind) {
      case SurfaceKind::plane:
        return {object, static_cast<double>(flat_side(scene_.planes[leader_.index].shading, ray_.direction))};
      case SurfaceKind::triangle:
        return {object, static_cast<double>(flat_side(scene_.triangle_shading[leader_.index], ray_.direction))};
      default:
        return {object, shade_sphere(scene_.spheres[leader_.index])};
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
    if (!(hit.t > Scalar(0))) return;
    const auto t = static_cast<double>(hit.t);
    const double error = t * relative_error;
    if (t - error > highest_) return;
    if (t + error < lowest_) {
      lead(hit, t - error, t + error);
      entered_ = false;
      return;
    }
    const bool leads = contend(contest_, scene_, ray_.direction, leader_, entered_, hit);
    lead(leads ? hit : leader_, contest_.lowest(), contest_.highest());
    entered_ = true;
  }

  void lead(const Hit<Scalar>& hit, double lowest, double highest) {
    leader_ = hit;
    lowest_ = lowest;
    highest_ = highest;
    depth_limit_ = static_cast<DepthLimit<Scalar>>(highest * static_cast<double>(ray_.direction.x));
  }

  void count(SurfaceKind kind, std::uint64_t tests) { work_.surface_tests[static_cast<std::size_t>(kind)] += tests; }

  /// Lambert's cosine law on the side that the ray meets: ambient + (1 - ambient) max(0, -n . l); a cosine beyond 1, or
  /// none at all, is a narrow format's mistake.
  double shade_sphere(const SphereSurface<Scalar>& sphere) const {
    if (!scene_.lit) return 1;
    const Vector<Scalar> outward = ray_.direction * leader_.t - sphere.center;
    const Scalar side = sphere.power < Scalar(0) ? -sphere.radius : sphere.radius;
    const Scalar cosine = dot(outward, scene_.towards_light) / side;
    const Scalar lit = std::min(std::max(Scalar(0), cosine), Scalar(1));
    return static_cast<double>(scene_.ambient + (Scalar(1) - scene_.ambient) * lit);
  }

  const PreparedScene<Scalar>& scene_;
  const ViewRay<Scalar> ray_;
  Work& work_;
  Contest& contest_;
  Hit<Scalar> leader_{Scalar(0), SurfaceKind::plane, no_object};
  bool entered_ = true;        ///< whether the leader is in the contest; else nothing else is
  double lowest_ = infinity;   ///< what ends before it is nearer than all hits so far
  double highest_ = infinity;  ///< what begins beyond it is behind
  DepthLimit<Scalar> depth_limit_ = std::numeric_limits<DepthLimit<Scalar>>::infinity();  ///< of boxes, likewise
};

/// What the ray sees: among the planes, and the bounded surfaces below `root` (as Node::child).
template <class Scalar>
Sample nearest_hit(const PreparedScene<Scalar>& scene, const Vector<Scalar>& view_vector, std::int32_t root,
                   Work& work) {
  Contest contest;
  Walk<Scalar> walk(scene, view_vector, work, contest);
  do {
    walk.test_planes();
    walk.traverse(root);
  } while (walk.repeats());
  return walk.shade();
}

}  // namespace pyrasim
