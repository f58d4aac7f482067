// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "numeric/number_format.h"
#include "numeric/number_range.h"
#include "surface/rounding_units.h"

namespace pyrasim {

/// Roundings (2^(1-P)) of the largest coordinate by which bounds are grown, so that a ray that a surface counts as hit
/// never misses the box around it, and results do not depend on the hierarchy. A slope is exact, a bound errs by 1/2 of
/// a rounding. Of a sphere, the centre errs by 1/2, the component across the ray by 1 in each coordinate, the squares
/// by 2 of the radius; t, which is compared with the depth of boxes, by 5. Of a triangle, a sheared coordinate errs by
/// 3/2, and t, a mean of its vertices, by 3. In a narrow format the boxes so become wide, and more surfaces are tested.
/// There is an exception: where products of coordinates fall below the smallest number of a narrow
/// format, a test has nothing left to decide by, and a triangle may count as hit by rays far from it; whether it is
/// asked then depends on the boxes. What preparation may have moved a surface by is added, so that
/// a box never begins deeper than the range in which an exact hit may lie (distance_range.h).
inline constexpr double margin_roundings = 8;

/// A quadric's kernel errs in the quadric's frame, where lengths along one axis may be shorter than along another: by
/// 7/2 roundings of the direction times the distance, 1/2 of the origin and 1 of their moment. So far it moves the
/// surface in its frame, in the world as many times as far as the frame is uneven, and twice that is more than 8
/// times 2.
///
/// That is for rays across. One nearly along a generator comes near the surface slowly: in the frame's measure it runs
/// by |m| while it runs by 1, |m| much less than 1, and where it passes nearest is known to e / |m| only, where e is as
/// much as above. But within the length f that it has until it leaves the surface's bounds it comes no nearer than by
/// |m| f. So a ray that counts as hit is off by no more than the less of the two, which is at most the root of e f.

/// How far from a surface a ray may run that the datapath counts as a hit.
class Margin {
 public:
  /// `longest_squared`: the squared length of the longest direction.
  Margin(const NumberFormat& format, double longest_squared, const RoundingUnits& rounding) : rounding_(rounding) {
    const double resolution = std::ldexp(1.0, -finest_fraction_bits(format));
    if (format.kind == NumberKind::fixed) {
      // Errors are absolute there; the longest direction multiplies them twice.
      relative_ = absolute_ = margin_roundings * resolution * longest_squared;
    } else {
      relative_ = std::ldexp(margin_roundings, 1 - format.significand_bits);
    }
    absolute_ += square_root_margin * std::sqrt(resolution);
  }

  template <class Surface>
  double of(const Surface& surface) const {
    if constexpr (requires { has_generators(surface); }) {
      if (has_generators(surface)) return across(surface) + along_generators(reach(surface));
    }
    return across(surface);
  }
  /// The same of rays that do not run along a generator; and how far from the surface the place may lie that is counted
  /// as hit, whichever way the ray runs: one along a generator runs along the surface.
  template <class Surface>
  double across(const Surface& surface) const {
    if constexpr (requires { unevenness(surface); }) return 2 * unevenness(surface) * of(reach(surface));
    return of(reach(surface));
  }
  /// e is 7 roundings of the root of 3 of the largest coordinate at most, f twice that.
  double along_generators(double largest_coordinate) const {
    return 2 * std::sqrt(of(largest_coordinate) * largest_coordinate);
  }
  double of(double largest_coordinate) const {
    return relative_ * largest_coordinate + absolute_ + rounding_.written(largest_coordinate);
  }

 private:
  /// A squared distance is lost with the smallest number; a distance, with its root.
  static constexpr double square_root_margin = 2;
  RoundingUnits rounding_;
  double relative_ = 0;
  double absolute_ = 0;
};

}  // namespace pyrasim
