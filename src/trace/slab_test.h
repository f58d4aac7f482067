// SPDX-License-Identifier: Apache-2.0
// Slab test of the two boxes of a node at once.
#pragma once

#include <algorithm>
#include <array>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include "trace/prepared_scene.h"
#include "trace/ray.h"

namespace pyrasim {

/// Where a ray enters each of a node's boxes, and which boxes it meets.
template <class Scalar>
struct SlabHits {
  std::array<Scalar, 2> entry;
  unsigned mask;  ///< bit k: the ray meets box k within 0 <= t <= limit
};

template <class Scalar>
SlabHits<Scalar> test_slabs(const typename PreparedScene<Scalar>::Node& node, const ViewRay<Scalar>& ray,
                            Scalar limit) {
  const auto [x, y, z] = ray.backward;
  SlabHits<Scalar> hits{{}, 0};
  for (std::size_t k = 0; k < 2; ++k) {
    const Scalar entry = std::max(std::max(node.bounds[0][x][k] * ray.inverse.x, Scalar(0)),
                                  std::max(node.bounds[1][y][k] * ray.inverse.y, node.bounds[2][z][k] * ray.inverse.z));
    const Scalar exit =
        std::min(std::min(node.bounds[0][1 - x][k] * ray.inverse.x, limit),
                 std::min(node.bounds[1][1 - y][k] * ray.inverse.y, node.bounds[2][1 - z][k] * ray.inverse.z));
    hits.entry[k] = entry;
    hits.mask |= (entry <= exit ? 1U : 0U) << k;
  }
  return hits;
}

#if defined(__SSE2__)
/// The same operations, both boxes in one register.
template <>
inline SlabHits<double> test_slabs<double>(const PreparedScene<double>::Node& node, const ViewRay<double>& ray,
                                           double limit) {
  const auto [x, y, z] = ray.backward;
  const __m128d inverse_x = _mm_set1_pd(ray.inverse.x);
  const __m128d inverse_y = _mm_set1_pd(ray.inverse.y);
  const __m128d inverse_z = _mm_set1_pd(ray.inverse.z);
  const auto product = [&node](std::size_t axis, std::size_t side, __m128d inverse) {
    return _mm_mul_pd(_mm_load_pd(node.bounds[axis][side].data()), inverse);
  };
  const __m128d entry = _mm_max_pd(_mm_max_pd(product(0, x, inverse_x), _mm_setzero_pd()),
                                   _mm_max_pd(product(1, y, inverse_y), product(2, z, inverse_z)));
  const __m128d exit = _mm_min_pd(_mm_min_pd(product(0, 1U - x, inverse_x), _mm_set1_pd(limit)),
                                  _mm_min_pd(product(1, 1U - y, inverse_y), product(2, 1U - z, inverse_z)));
  SlabHits<double> hits;
  _mm_storeu_pd(hits.entry.data(), entry);
  hits.mask = static_cast<unsigned>(_mm_movemask_pd(_mm_cmple_pd(entry, exit)));
  return hits;
}
#endif

}  // namespace pyrasim
