// SPDX-License-Identifier: Apache-2.0
// Finds the surface that a view ray sees, and its shading; in any number format.
#pragma once

#include <cstdint>
#include <limits>
#include <tuple>

#include "intersect/box_test.h"
#include "intersect/illumination.h"
#include "intersect/instance_walk.h"
#include "intersect/prepared_scene.h"
#include "intersect/standing.h"
#include "intersect/traversal.h"
#include "intersect/work.h"
#include "raster/sample.h"
#include "surface/view_ray.h"

namespace pyrasim {

/// The same of an instance's triangle.
template <class Scalar>
[[gnu::noinline]] Sample shade_triangle(const PreparedScene<Scalar>& scene, const Vector<Scalar>& direction,
                                        const Hit<Scalar>& hit) {
  const InstancedTriangle<Scalar> triangle = triangle_of_hit(scene, hit.index);
  return {{triangle.identity.object}, Shading(static_cast<double>(triangle.shade(scene.lighting, direction)))};
}

/// What the ray sees of the surface that it met, if any.
template <class Scalar>
[[gnu::always_inline]] inline Sample shade(const PreparedScene<Scalar>& scene, const Vector<Scalar>& direction,
                                           const Hit<Scalar>* hit, ShadowWork& work) {
  if (hit == nullptr) return {};
  if (scene.illumination != nullptr) return scene.illumination->sample(direction, *hit, work);
  return with_kind(
      hit->kind, [&](auto kind) __attribute__((always_inline)) {
        if constexpr (kind == index_of_kind<InstanceSurface>) {
          return shade_triangle(scene, direction, *hit);
        } else {
          const auto& [surfaces, shading] = std::get<kind>(scene.kinds);
          const auto& surface = surfaces[hit->index];
          const Scalar seen = surface.shade(shading[hit->index], scene.lighting, direction, hit->t);
          return Sample{{surface.identity.object}, Shading(static_cast<double>(seen))};
        }
      });
}

/// One ray on its way through a scene. What it meets enters `Standing`, one of standing.h.
template <class Scalar, class Standing>
class Walk {
 public:
  Walk(const PreparedScene<Scalar>& scene, const Vector<Scalar>& view_vector, Work& work, Standing& standing)
      : scene_(scene), ray_(view_vector), work_(work), standing_(standing) {}

  /// Through the surfaces without bounds, and the hierarchy below `root`.
  [[gnu::always_inline]] void go(std::int32_t root) {
    if (scene_.apart) test_apart(*scene_.apart);
    const auto test = [this](std::int32_t leaf) __attribute__((always_inline)) { test_leaf(leaf); };
    traverse(scene_.nodes.data(), root, *this, test, work_);
  }

  // The query of traverse().
  unsigned met(const WideNode<Scalar>& node) const { return met_boxes(node.boxes, ray_, depth_limit_); }
  bool behind(const WideNode<Scalar>& node, std::size_t k) const {
    return static_cast<DepthLimit<Scalar>>(node.boxes.depth[k]) > depth_limit_;
  }

 private:
  /// Spheres stand first: apart from the loop over runs the compiler keeps their numbers in registers.
  [[gnu::always_inline]] void test_leaf(std::int32_t leaf) {
    const SurfaceRun* run = first_run(scene_.runs, leaf);
    if (run->kind == kind_of<SphereSurface>) {
      test_run<index_of_kind<SphereSurface>>(*run);
      if (!run->more) return;
      ++run;
    }
    do {
      with_kind(
          run->kind, [&](auto kind) __attribute__((always_inline)) {
            constexpr bool may_be_here = surface_traits[kind].extent != Extent::unbounded;
            if constexpr (kind == index_of_kind<InstanceSurface>) {
              standing_ = after_instances(scene_, ray_.direction, *run, standing_, work_);
              lower_depth_limit();
            } else if constexpr (may_be_here && kind != index_of_kind<SphereSurface>) {
              test_run<kind>(*run);
            }
          });
    } while (run++->more);
  }

  [[gnu::always_inline]] void test_apart(std::int32_t leaf) {
    const SurfaceRun* run = first_run(scene_.runs, leaf);
    do {
      with_kind(
          run->kind, [&](auto kind) __attribute__((always_inline)) {
            if constexpr (surface_traits[kind].extent != Extent::bounded) test_run<kind>(*run);
          });
    } while (run++->more);
  }

  template <std::size_t kind>
  [[gnu::always_inline]] void test_run(const SurfaceRun& run) {
    using Surface = std::tuple_element_t<kind, SurfaceTypes<Scalar>>;
    const auto& surfaces = std::get<kind>(scene_.kinds).surfaces;
    const typename Surface::Terms terms(ray_);
    for (std::uint32_t k = run.first; k < run.first + run.count; ++k) {
      const Surface& surface = surfaces[k];
      const Scalar t = surface.intersect(terms);
      if constexpr (requires { surface.error; }) {
        offer({t, kind_at<kind>, k},
              surface.error.at(static_cast<double>(t), static_cast<double>(ray_.inverse_length_squared)));
      } else {
        offer({t, kind_at<kind>, k}, run.relative_error);
      }
    }
    work_.surface_tests[kind] += run.count;
  }

  void offer(const Hit<Scalar>& hit, double relative_error) {
    if (hit.t > Scalar(0) && standing_.enter(hit, relative_error)) lower_depth_limit();
  }

  void lower_depth_limit() {
    depth_limit_ = static_cast<DepthLimit<Scalar>>(standing_.highest() * static_cast<double>(ray_.direction.x));
  }

  const PreparedScene<Scalar>& scene_;
  const ViewRay<Scalar> ray_;
  Work& work_;
  Standing& standing_;
  DepthLimit<Scalar> depth_limit_ = std::numeric_limits<DepthLimit<Scalar>>::infinity();  ///< boxes beyond are behind
};

/// What the ray sees among the surfaces without bounds and those below `root` (as Node::child). The tests in `work`
/// become `before` and those made.
template <class Scalar>
Sample nearest_of_close_hits(const PreparedScene<Scalar>& scene, const Vector<Scalar>& view_vector, std::int32_t root,
                             const Tests& before, Work& work) {
  static_cast<Tests&>(work) = before;
  CloseStanding<Scalar> standing(scene, view_vector);
  Walk<Scalar, CloseStanding<Scalar>> walk(scene, view_vector, work, standing);
  do {
    walk.go(root);
  } while (standing.repeats());
  return shade(scene, view_vector, standing.leader(), work.shadow);
}

extern template Sample nearest_of_close_hits(const PreparedScene<double>&, const Vector<double>&, std::int32_t,
                                             const Tests&, Work&);

/// The same; adds the tests made to `work`. Nearly all rays of nearly all scenes meet surfaces that lie clearly apart;
/// whoever does not starts again. That pays in double, where errors are so small that hardly a box lies between what is
/// coarsely known of them and what is known of a hit.
template <class Scalar>
[[gnu::always_inline]] inline Sample nearest_hit(const PreparedScene<Scalar>& scene, const Vector<Scalar>& view_vector,
                                                 std::int32_t root, Work& work) {
  const Tests before = work;
  if constexpr (std::is_same_v<Scalar, double>) {
    ClearStanding<Scalar> standing;
    Walk<Scalar, ClearStanding<Scalar>> walk(scene, view_vector, work, standing);
    walk.go(root);
    if (!standing.undecided()) [[likely]]
      return shade(scene, view_vector, standing.leader(), work.shadow);
  }
  return nearest_of_close_hits(scene, view_vector, root, before, work);
}

}  // namespace pyrasim
