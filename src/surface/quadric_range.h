// SPDX-License-Identifier: Apache-2.0
// Where a quadric may be hit first, given in which ranges its roots and the ends of what planes leave of the ray lie.
#pragma once

#include <limits>

#include "surface/distance_range.h"

namespace pyrasim {

/// QuadricRoots, each end known to a range.
struct QuadricRootRanges {
  bool certain;    ///< whether there are roots; else there may be none
  bool possible;   ///< whether there may be any
  bool shapeless;  ///< nothing is known: which side of a root is inside, nor where another one is
  bool outside;    ///< as in QuadricRoots
  bool inside_without_roots;
  DistanceRange first, last;  ///< -infinity or infinity where there is none
};

/// Stretch, each end known to a range.
struct StretchRanges {
  DistanceRange begin{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  DistanceRange end{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};

  void keep_from(const DistanceRange& t) { begin = later(begin, t); }
  void keep_to(const DistanceRange& t) { end = earlier(end, t); }
  bool possible() const { return begin.lowest <= end.highest; }
  bool certain() const { return begin.highest <= end.lowest; }
};

/// The first of the hits that come one by one, in the order in which a ray meets them.
class FirstHitRange {
 public:
  /// A hit that there may be, or `certainly` is, if it lies ahead.
  void add(const DistanceRange& range, bool certainly);
  /// The ends of a stretch inside a solid.
  void add_stretch(const StretchRanges& stretch, bool certainly);

  bool possible() const { return range_.lowest <= range_.highest; }
  bool certain() const { return closed_; }
  const DistanceRange& range() const { return range_; }

 private:
  DistanceRange range_{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  bool closed_ = false;  ///< a certain one came
};

FirstHitRange first_hit_range(const QuadricRootRanges& roots, const StretchRanges& kept, bool capped);

}  // namespace pyrasim
