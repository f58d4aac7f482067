// SPDX-License-Identifier: Apache-2.0
// What hits of surfaces far away err by, of rays that keep off outlines.
#pragma once

#include "../ties/every_hit.h"
#include "../ties/exact_distance.h"
#include "formats.h"

namespace pyrasim {

/// Far out a double holds no decimal numbers.
inline glm::dvec3 whole(const glm::dvec3& v) { return {std::round(v.x), std::round(v.y), std::round(v.z)}; }

/// Whether rays by `unit` beside `v` hit or miss, or at quite another place: within a band about an outline.
/// exact_along(v) is the exact distance along a view vector, if there is one.
template <class ExactAlong>
bool in_band(const ExactAlong& exact_along, const glm::dvec3& v, double unit, const std::optional<Real>& exact) {
  for (const double y : {-unit, unit}) {
    for (const double z : {-unit, unit}) {
      const auto there = exact_along(glm::dvec3(v.x, v.y + y, v.z + z));
      if (there.has_value() != exact.has_value()) return true;
      if (exact && abs(*there - *exact) > *exact * Real(0x1p-6)) return true;
    }
  }
  return false;
}

struct FarHits {
  int wrong = 0;               ///< hits where there is nothing, and misses
  std::vector<double> of_t{};  ///< their errors, in units of the last place

  double p99() const {
    auto sorted = of_t;
    std::sort(sorted.begin(), sorted.end());
    return sorted.empty() ? 0 : sorted[sorted.size() * 99 / 100];
  }

  /// Adds the ray towards `target`, in observer's coordinates, unless 64 units of the last place beside it is an
  /// outline. `tester` is of one surface, in the format of `Scalar`.
  template <class Scalar, class ExactAlong>
  void add(const EveryHit& tester, const ExactAlong& exact_along, const glm::dvec3& target) {
    const glm::dvec3 v(1, as_held<Scalar>(target.y / target.x), as_held<Scalar>(target.z / target.x));
    const auto exact = exact_along(v);
    if (in_band(exact_along, v, 64 * std::ldexp(1.0, 1 - significand_bits<Scalar>()), exact)) return;
    const auto hits = tester.of(v);
    if (hits.empty() == exact.has_value()) ++wrong;
    if (hits.empty() || !exact) return;
    const Real scaled = *exact * Real(std::ldexp(1.0, tester.exponent()));
    of_t.push_back(error_in_ulp(static_cast<Scalar>(hits[0].t), scaled));
  }
};

}  // namespace pyrasim
