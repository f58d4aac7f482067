// SPDX-License-Identifier: Apache-2.0
// Slab test of the boxes of a node at once.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#if defined(__AVX__)
#include <immintrin.h>
#elif defined(__SSE2__)
#include <emmintrin.h>
#endif

#include "trace/prepared_scene.h"
#include "trace/ray.h"

namespace pyrasim {

/// Where a ray enters each of a node's boxes, and which boxes it meets.
template <class Scalar>
struct SlabHits {
  std::array<Scalar, node_width> entry;
  unsigned mask;  ///< bit k: the ray meets box k within 0 <= t <= limit
};

/// The boxes' test for one ray.
template <class Scalar>
class SlabTest {
 public:
  explicit SlabTest(const ViewRay<Scalar>& ray) : ray_(ray) {}

  SlabHits<Scalar> operator()(const typename PreparedScene<Scalar>::Node& node, Scalar limit) const {
    const auto [x, y, z] = ray_.backward;
    SlabHits<Scalar> hits{{}, 0};
    for (std::size_t k = 0; k < node_width; ++k) {
      const Scalar entry =
          std::max(std::max(node.bounds[0][x][k] * ray_.inverse.x, Scalar(0)),
                   std::max(node.bounds[1][y][k] * ray_.inverse.y, node.bounds[2][z][k] * ray_.inverse.z));
      const Scalar exit =
          std::min(std::min(node.bounds[0][1 - x][k] * ray_.inverse.x, limit),
                   std::min(node.bounds[1][1 - y][k] * ray_.inverse.y, node.bounds[2][1 - z][k] * ray_.inverse.z));
      hits.entry[k] = entry;
      hits.mask |= (entry <= exit ? 1U : 0U) << k;
    }
    return hits;
  }

 private:
  const ViewRay<Scalar>& ray_;
};

#if defined(__AVX__)
/// The same operations, all boxes in one register, and what the ray decides worked out before.
template <>
class SlabTest<double> {
 public:
  explicit SlabTest(const ViewRay<double>& ray)
      : inverse_x_(_mm256_set1_pd(ray.inverse.x)),
        inverse_y_(_mm256_set1_pd(ray.inverse.y)),
        inverse_z_(_mm256_set1_pd(ray.inverse.z)),
        near_x_(std::size_t{4} * ray.backward[0]),
        near_y_(8 + std::size_t{4} * ray.backward[1]),
        near_z_(16 + std::size_t{4} * ray.backward[2]) {}

  SlabHits<double> operator()(const PreparedScene<double>::Node& node, double limit) const {
    // Doubles of Node::bounds in a row: axis * 8 + side * 4 + child. The far side differs in the bit of value 4.
    const double* const bounds = node.bounds.front().front().data();
    const auto distance = [bounds](std::size_t at, __m256d inverse) {
      return _mm256_mul_pd(_mm256_load_pd(bounds + at), inverse);
    };
    const __m256d entry = _mm256_max_pd(_mm256_max_pd(distance(near_x_, inverse_x_), _mm256_setzero_pd()),
                                        _mm256_max_pd(distance(near_y_, inverse_y_), distance(near_z_, inverse_z_)));
    const __m256d exit =
        _mm256_min_pd(_mm256_min_pd(distance(near_x_ ^ 4U, inverse_x_), _mm256_set1_pd(limit)),
                      _mm256_min_pd(distance(near_y_ ^ 4U, inverse_y_), distance(near_z_ ^ 4U, inverse_z_)));
    SlabHits<double> hits;
    _mm256_storeu_pd(hits.entry.data(), entry);
    hits.mask = static_cast<unsigned>(_mm256_movemask_pd(_mm256_cmp_pd(entry, exit, _CMP_LE_OQ)));
    return hits;
  }

 private:
  __m256d inverse_x_, inverse_y_, inverse_z_;
  std::size_t near_x_, near_y_, near_z_;  ///< where the sides that the ray meets first stand
};
#elif defined(__SSE2__)
/// The same operations, two boxes in a register, all that the ray decides worked out before.
template <>
class SlabTest<double> {
 public:
  explicit SlabTest(const ViewRay<double>& ray)
      : inverse_x_(_mm_set1_pd(ray.inverse.x)),
        inverse_y_(_mm_set1_pd(ray.inverse.y)),
        inverse_z_(_mm_set1_pd(ray.inverse.z)),
        near_x_(std::size_t{4} * ray.backward[0]),
        near_y_(8 + std::size_t{4} * ray.backward[1]),
        near_z_(16 + std::size_t{4} * ray.backward[2]) {}

  SlabHits<double> operator()(const PreparedScene<double>::Node& node, double limit) const {
    // Doubles of Node::bounds in a row: axis * 8 + side * 4 + child. The far side differs in the bit of value 4.
    const double* const bounds = node.bounds.front().front().data();
    SlabHits<double> hits;
    const unsigned first = test(bounds, limit, hits.entry.data());
    const unsigned second = test(bounds + 2, limit, hits.entry.data() + 2);
    hits.mask = first | (second << 2U);
    return hits;
  }

 private:
  unsigned test(const double* bounds, double limit, double* entries) const {
    const __m128d entry =
        _mm_max_pd(_mm_max_pd(_mm_mul_pd(_mm_load_pd(bounds + near_x_), inverse_x_), _mm_setzero_pd()),
                   _mm_max_pd(_mm_mul_pd(_mm_load_pd(bounds + near_y_), inverse_y_),
                              _mm_mul_pd(_mm_load_pd(bounds + near_z_), inverse_z_)));
    const __m128d exit =
        _mm_min_pd(_mm_min_pd(_mm_mul_pd(_mm_load_pd(bounds + (near_x_ ^ 4U)), inverse_x_), _mm_set1_pd(limit)),
                   _mm_min_pd(_mm_mul_pd(_mm_load_pd(bounds + (near_y_ ^ 4U)), inverse_y_),
                              _mm_mul_pd(_mm_load_pd(bounds + (near_z_ ^ 4U)), inverse_z_)));
    _mm_storeu_pd(entries, entry);
    return static_cast<unsigned>(_mm_movemask_pd(_mm_cmple_pd(entry, exit)));
  }

  __m128d inverse_x_, inverse_y_, inverse_z_;
  std::size_t near_x_, near_y_, near_z_;  ///< where the sides that the ray meets first stand
};
#endif

}  // namespace pyrasim
