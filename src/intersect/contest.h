// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <tuple>

#include "surface/distance_range.h"

namespace pyrasim {

/// What decides between hits at one place: the object, in the order of the scene; of one object's hits the nearer by t,
/// for the sake of its shading.
struct Rank {
  std::uint32_t object = std::numeric_limits<std::uint32_t>::max();
  double t = 0;
  std::uint32_t order = 0;  ///< as in SurfaceIdentity
  friend bool operator<(const Rank& a, const Rank& b) {
    return std::tie(a.object, a.t, a.order) < std::tie(b.object, b.t, b.order);
  }
};

/// Decision D7 among a ray's hits, which come one by one: the first in rank of those that are not certainly behind
/// another one. A hit is certainly behind if its whole range is beyond the end of another's; so m, the least of all
/// ends, decides, and neither the order in which hits come nor what lies between two of them does.
///
/// A hit that had to give way to one of lower rank is forgotten, but for where its range begins. If that one turns
/// out to be behind a nearer hit, the one forgotten may not be: then the ray has to be walked again, with m known.
class Contest {
 public:
  /// Whether this hit leads now.
  bool enter(const DistanceRange& range, const Rank& rank) {
    if (range.lowest > highest_) return false;
    highest_ = std::min(highest_, range.highest);
    if (leader_ > highest_) {
      forsaken_ = std::min(forsaken_, forgotten_);
      forgotten_ = infinity;
    } else if (rank < rank_) {
      forgotten_ = std::min(forgotten_, leader_);
    } else {
      forgotten_ = std::min(forgotten_, range.lowest);
      return false;
    }
    leader_ = range.lowest;
    rank_ = rank;
    return true;
  }

  /// m: what begins beyond is behind.
  double highest() const { return highest_; }

  /// Once all hits have come: whether a forgotten one may be the winner.
  bool in_doubt() const { return forsaken_ < infinity && forsaken_ <= highest_; }
  /// All hits are going to come once more.
  void repeat() {
    leader_ = highest_;  // nobody's, but as good as any: m does not change any more
    forgotten_ = forsaken_ = infinity;
    rank_ = {};
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  double leader_ = infinity;     ///< where the leading hit's range begins
  double highest_ = infinity;    ///< m
  double forgotten_ = infinity;  ///< the least beginning of hits that gave way to the leader or to whom he followed
  double forsaken_ = infinity;   ///< of those that gave way to a leader who was behind
  Rank rank_;                    ///< the leader's
};

}  // namespace pyrasim
