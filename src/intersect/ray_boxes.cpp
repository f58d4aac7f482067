// SPDX-License-Identifier: Apache-2.0
#include "intersect/ray_boxes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#if defined(__AVX__)
#include <immintrin.h>
#endif

#include "numeric/vectors.h"

namespace pyrasim {
namespace {

constexpr double longest_squared = 3;
constexpr double granted = 1 + 16 * 0x1p-53;
/// As far as rays go that have no limit: less far than those get that run beside a box along its planes.
constexpr double furthest = 0x1p1000;

}  // namespace

RayBoxes::RayBoxes(const PreparedScene<double>& scene, const NumberFormat& format)
    : margin_(format, longest_squared, scene.rounding), nodes_(scene.nodes.size()) {
  add(scene, scene.root);
}

/// Fills in the boxes below `reference` and returns what holds all of them.
BoundingBox RayBoxes::add(const PreparedScene<double>& scene, std::int32_t reference) {
  BoundingBox all;
  if (reference >= 0) {
    const auto index = static_cast<std::size_t>(reference);
    for (std::size_t k = 0; k < scene.nodes[index].children; ++k) {
      const BoundingBox child = add(scene, scene.nodes[index].child[k]);
      for (int axis = 0; axis < 3; ++axis) {
        nodes_[index].lower[static_cast<std::size_t>(axis)][k] = child.lower[axis];
        nodes_[index].upper[static_cast<std::size_t>(axis)][k] = child.upper[axis];
      }
      nodes_[index].children |= 1U << k;
      all.include(child);
    }
    return all;
  }
  const SurfaceRun* run = first_run(scene.runs, reference);
  do {
    with_kind(run->kind, [&](auto kind) {
      for (std::uint32_t k = run->first; k < run->first + run->count; ++k) {
        const auto& surface = std::get<kind>(scene.kinds).surfaces[k];
        const auto box = bounds(surface);
        if (!box) continue;  // it stands apart, and no box is asked for it
        const double margin = 2 * margin_.of(surface);
        if constexpr (requires { has_generators(surface); }) generators_ = generators_ || has_generators(surface);
        all.include(BoundingBox{box->lower - margin, box->upper + margin});
      }
    });
  } while (run++->more);
  return all;
}

/// A ray along an axis' planes is between them for ever or never: far enough in either direction, for the numbers there
/// are. On a plane itself it may be taken for outside: no surface is that close to it, for boxes are grown.
RayBoxes::Query RayBoxes::query(const GeneralRay& ray) const {
  const double away = largest(ray.origin);
  const double margin = 2 * margin_.of(away) + (generators_ ? margin_.along_generators(away) : 0);
  const auto inverse = [](double direction) {
    constexpr double most = std::numeric_limits<double>::max();
    return direction == 0 ? most : std::clamp(1 / direction, -most, most);
  };
  return {ray.origin + margin,
          ray.origin - margin,
          {inverse(ray.direction.x), inverse(ray.direction.y), inverse(ray.direction.z)}};
}

/// The slab test (Kay, Kajiya 1986): per axis the t at which the ray passes two planes, each by a difference, a
/// reciprocal and a product; the last comparison grants their roundings (Ize, Robust BVH Ray Traversal, JCGT 2013).
#if defined(__AVX__)
unsigned RayBoxes::met(std::size_t node, const Query& query, double limit) const {
  const Node& boxes = nodes_[node];
  __m256d enter = _mm256_setzero_pd();
  __m256d leave = _mm256_set1_pd(std::min(limit, furthest));
  for (int axis = 0; axis < 3; ++axis) {
    const auto k = static_cast<std::size_t>(axis);
    const __m256d inverse = _mm256_set1_pd(query.inverse[axis]);
    const auto passed = [&](const Node::Bound& bound, double from) {
      return _mm256_mul_pd(_mm256_sub_pd(_mm256_load_pd(bound.data()), _mm256_set1_pd(from)), inverse);
    };
    const __m256d a = passed(boxes.lower[k], query.above[axis]);
    const __m256d b = passed(boxes.upper[k], query.below[axis]);
    enter = _mm256_max_pd(enter, _mm256_min_pd(a, b));
    leave = _mm256_min_pd(leave, _mm256_max_pd(a, b));
  }
  const __m256d met = _mm256_cmp_pd(enter, _mm256_mul_pd(leave, _mm256_set1_pd(granted)), _CMP_LE_OQ);
  return static_cast<unsigned>(_mm256_movemask_pd(met)) & boxes.children;
}
#else
unsigned RayBoxes::met(std::size_t node, const Query& query, double limit) const {
  const Node& boxes = nodes_[node];
  unsigned met = 0;
  for (std::size_t k = 0; k < node_width; ++k) {
    double enter = 0;
    double leave = std::min(limit, furthest);
    for (int axis = 0; axis < 3; ++axis) {
      const auto which = static_cast<std::size_t>(axis);
      const double a = (boxes.lower[which][k] - query.above[axis]) * query.inverse[axis];
      const double b = (boxes.upper[which][k] - query.below[axis]) * query.inverse[axis];
      enter = std::max(enter, std::min(a, b));
      leave = std::min(leave, std::max(a, b));
    }
    if (enter <= leave * granted) met |= 1U << k;
  }
  return met & boxes.children;
}
#endif

}  // namespace pyrasim
