// SPDX-License-Identifier: Apache-2.0
// Tests the boxes of a node at once.
#pragma once

#include <cstddef>
#include <type_traits>

#if defined(__AVX__)
#include <immintrin.h>
#endif

#include "intersect/prepared_scene.h"
#include "surface/view_ray.h"

namespace pyrasim {

/// A depth that is compared with those of boxes, in the processor's own numbers: rounding it to them changes no
/// comparison, and counts as no operation of the datapath.
template <class Scalar>
using DepthLimit = std::conditional_t<std::is_floating_point_v<Scalar>, Scalar, double>;

/// Bit k: the ray meets box k of the node no deeper than `depth_limit`.
template <class Scalar>
unsigned met_boxes(const SlopeBoxes<Scalar>& boxes, const ViewRay<Scalar>& ray, DepthLimit<Scalar> depth_limit) {
  unsigned met = 0;
  for (std::size_t k = 0; k < node_width; ++k) {
    const auto holds = [](bool comparison) { return comparison ? 1U : 0U; };
    met |= (holds(static_cast<DepthLimit<Scalar>>(boxes.depth[k]) <= depth_limit) &
            holds(boxes.lower_y[k] <= ray.slope_y) & holds(boxes.upper_y[k] >= ray.slope_y) &
            holds(boxes.lower_z[k] <= ray.slope_z) & holds(boxes.upper_z[k] >= ray.slope_z))
           << k;
  }
  return met;
}

#if defined(__AVX__)
/// The same comparisons, all boxes in one register.
inline unsigned met_boxes(const SlopeBoxes<double>& boxes, const ViewRay<double>& ray, double depth_limit) {
  const auto at_most = [](const std::array<double, node_width>& bound, double value) {
    return _mm256_cmp_pd(_mm256_load_pd(bound.data()), _mm256_set1_pd(value), _CMP_LE_OQ);
  };
  const auto at_least = [](const std::array<double, node_width>& bound, double value) {
    return _mm256_cmp_pd(_mm256_load_pd(bound.data()), _mm256_set1_pd(value), _CMP_GE_OQ);
  };
  const __m256d y = _mm256_and_pd(at_most(boxes.lower_y, ray.slope_y), at_least(boxes.upper_y, ray.slope_y));
  const __m256d z = _mm256_and_pd(at_most(boxes.lower_z, ray.slope_z), at_least(boxes.upper_z, ray.slope_z));
  const __m256d met = _mm256_and_pd(_mm256_and_pd(y, z), at_most(boxes.depth, depth_limit));
  return static_cast<unsigned>(_mm256_movemask_pd(met));
}
#endif

}  // namespace pyrasim
