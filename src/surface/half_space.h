// SPDX-License-Identifier: Apache-2.0
// What planes leave of a ray: surfaces that are clipped, or closed by flat caps, compare values of t alone, so that
// where a shell ends and a cap begins there is neither a gap nor an overlap.
#pragma once

#include <algorithm>
#include <limits>

#include "numeric/compensated.h"

namespace pyrasim {

/// The points p with normal . p <= offset.
template <class Scalar>
struct HalfSpace {
  Vector<Scalar> normal;  ///< of any length
  Scalar offset;

  template <class Other, class Number>
  HalfSpace<Other> mapped(const Number& number) const {
    return {number(normal, 0), number(offset, 1)};
  }
};

/// The values of t from `begin` to `end`, both included; all that there are where nothing was cut off.
template <class Scalar>
struct Stretch {
  Scalar begin = std::numeric_limits<Scalar>::lowest();
  Scalar end = std::numeric_limits<Scalar>::max();

  bool empty() const { return !(begin <= end); }
  bool holds(Scalar t) const { return begin <= t && t <= end; }
  /// The first of its ends that lies ahead; 0 where there is none.
  Scalar first_end() const {
    if (empty()) return Scalar(0);
    if (begin > Scalar(0)) return begin;
    return end > Scalar(0) && end < std::numeric_limits<Scalar>::max() ? end : Scalar(0);
  }

  void keep_from(Scalar t) { begin = std::max(begin, t); }
  void keep_to(Scalar t) { end = std::min(end, t); }
  /// A ray along the plane is on one side of it for ever.
  void keep(const HalfSpace<Scalar>& half_space, const Vector<Scalar>& direction) {
    const Scalar approach = compensated_dot(half_space.normal, direction);
    if (approach == Scalar(0)) {
      if (half_space.offset < Scalar(0)) *this = {Scalar(0), Scalar(-1)};
      return;
    }
    const Scalar t = half_space.offset / approach;
    approach > Scalar(0) ? keep_to(t) : keep_from(t);
  }
};

}  // namespace pyrasim
