// SPDX-License-Identifier: Apache-2.0
// Where two datapaths see different things: the trace trees of a frame compared node by node.
#pragma once

#include <cstdint>

#include "camera/view_vector.h"
#include "intersect/intersector.h"
#include "numeric/number_format.h"
#include "render/parallel.h"
#include "scene/scene.h"

namespace pyrasim {

/// Counts over a frame. A decision is a pyramid's case and, where it is covered, the object.
struct DecisionFlips {
  std::uint64_t decisions = 0;           ///< of pyramids that both datapaths come to
  std::uint64_t flipped = 0;             ///< of these, that differ
  std::uint64_t extra_subdivisions = 0;  ///< that only the studied datapath makes, at any level
  std::uint64_t lost_subdivisions = 0;   ///< that only the reference makes

  DecisionFlips& operator+=(const DecisionFlips& other) {
    decisions += other.decisions;
    flipped += other.flipped;
    extra_subdivisions += other.extra_subdivisions;
    lost_subdivisions += other.lost_subdivisions;
    return *this;
  }
  friend bool operator==(const DecisionFlips&, const DecisionFlips&) = default;
};

/// A datapath: an intersector, and the format that view vectors are rounded to before.
struct StudiedDatapath {
  const Intersector& intersector;
  NumberFormat view_vectors;
};

/// Compares every pyramid of `scene` at MAX_LEVEL `max_level` on `threads` threads (0: one for each core).
DecisionFlips decision_flips(const Scene& scene, const StudiedDatapath& reference, const StudiedDatapath& studied,
                             int max_level, int threads);

}  // namespace pyrasim
