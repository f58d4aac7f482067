// SPDX-License-Identifier: Apache-2.0
#include "trace/scene_tracer.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "trace/hierarchy_builder.h"
#include "trace/plane.h"
#include "trace/slab_test.h"
#include "trace/sphere.h"
#include "trace/triangle.h"

namespace pyrasim {

template <class Scalar>
Sample SceneTracer<Scalar>::trace(const Vector<Scalar>& view_vector, Work& work) const {
  const ViewRay<Scalar> ray(view_vector);
  Candidate best{{std::numeric_limits<Scalar>::infinity(), no_object}, SurfaceKind::plane, no_object};
  for (std::uint32_t k = 0; k < scene_.planes.size(); ++k) {
    const Scalar t = intersect_plane(scene_.planes[k], view_vector);
    if (best.nearest.improved_by(t, scene_.planes[k].identity.order)) {
      best = {{t, scene_.planes[k].identity.order}, SurfaceKind::plane, k};
    }
  }
  work.surface_tests[static_cast<std::size_t>(SurfaceKind::plane)] += scene_.planes.size();
  if (!scene_.leaves.empty()) traverse(ray, best, work);
  return best.index == no_object ? Sample{} : shade(view_vector, best);
}

/// The nearest child first; the others wait, and are dropped if a hit before their box turns up meanwhile.
template <class Scalar>
void SceneTracer<Scalar>::traverse(const ViewRay<Scalar>& ray, Candidate& best, Work& work) const {
  struct Pending {
    Scalar entry;
    std::int32_t child;
  };
  std::array<Pending, (node_width - 1) * max_hierarchy_depth> stack;
  Pending* top = stack.data();
  const SlabTest<Scalar> test_slabs(ray);
  const auto* const nodes = scene_.nodes.data();
  std::uint64_t box_tests = 0;
  std::int32_t current = scene_.root;
  for (;;) {
    while (current >= 0) {
      const auto& node = nodes[current];
      box_tests += node.children;
      const SlabHits<Scalar> hits = test_slabs(node, best.nearest.t);
      if (hits.mask == 0) break;
      auto first = static_cast<std::size_t>(std::countr_zero(hits.mask));
      for (unsigned others = hits.mask & (hits.mask - 1); others != 0; others &= others - 1) {
        auto later = static_cast<std::size_t>(std::countr_zero(others));
        if (hits.entry[later] < hits.entry[first]) std::swap(first, later);
        *top++ = {hits.entry[later], node.child[later]};
      }
      current = node.child[first];
    }
    if (current < 0)
      test_leaf(scene_.leaves[static_cast<std::size_t>(~static_cast<std::int64_t>(current))], ray, best, work);
    do {
      if (top == stack.data()) {
        work.box_tests += box_tests;
        return;
      }
      --top;
    } while (top->entry > best.nearest.t);
    current = top->child;
  }
}

template <class Scalar>
void SceneTracer<Scalar>::test_leaf(const typename PreparedScene<Scalar>::Leaf& leaf, const ViewRay<Scalar>& ray,
                                    Candidate& best, Work& work) const {
  for (std::uint32_t k = leaf.first_sphere; k < leaf.first_sphere + leaf.spheres; ++k) {
    const Scalar t = intersect_sphere(scene_.spheres[k], ray.direction, ray.inverse_length_squared);
    const std::uint32_t order = scene_.spheres[k].identity.order;
    if (best.nearest.improved_by(t, order)) best = {{t, order}, SurfaceKind::sphere, k};
  }
  work.surface_tests[static_cast<std::size_t>(SurfaceKind::sphere)] += leaf.spheres;
  if (leaf.triangles == 0) return;
  const TriangleShear<Scalar> shear(ray.direction);
  for (std::uint32_t k = leaf.first_triangle; k < leaf.first_triangle + leaf.triangles; ++k) {
    const Scalar t = intersect_triangle(scene_.triangles[k], shear);
    const std::uint32_t order = scene_.triangles[k].identity.order;
    if (best.nearest.improved_by(t, order)) best = {{t, order}, SurfaceKind::triangle, k};
  }
  work.surface_tests[static_cast<std::size_t>(SurfaceKind::triangle)] += leaf.triangles;
}

namespace {

template <class Scalar>
Scalar flat_side(const FlatShading<Scalar>& shading, const Vector<Scalar>& direction) {
  return dot(shading.normal, direction) < Scalar(0) ? shading.front : shading.back;
}

}  // namespace

/// Lambert's cosine law on the side that the ray meets: ambient + (1 - ambient) max(0, -n . l).
template <class Scalar>
Sample SceneTracer<Scalar>::shade(const Vector<Scalar>& view_vector, const Candidate& hit) const {
  if (hit.kind == SurfaceKind::plane) {
    const auto& plane = scene_.planes[hit.index];
    return {plane.identity.object, static_cast<double>(flat_side(plane.shading, view_vector))};
  }
  if (hit.kind == SurfaceKind::triangle) {
    return {scene_.triangles[hit.index].identity.object,
            static_cast<double>(flat_side(scene_.triangle_shading[hit.index], view_vector))};
  }
  const auto& sphere = scene_.spheres[hit.index];
  if (!scene_.lit) return {sphere.identity.object, 1.0};
  const Vector<Scalar> outward = view_vector * hit.nearest.t - sphere.center;
  const Scalar side = sphere.power < Scalar(0) ? -sphere.inverse_radius : sphere.inverse_radius;
  const Scalar cosine = dot(outward, scene_.towards_light) * side;
  return {sphere.identity.object,
          static_cast<double>(scene_.ambient + (Scalar(1) - scene_.ambient) * std::max(cosine, Scalar(0)))};
}

template class SceneTracer<double>;
template class SceneTracer<float>;

}  // namespace pyrasim
