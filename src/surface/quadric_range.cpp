// SPDX-License-Identifier: Apache-2.0
#include "surface/quadric_range.h"

#include <algorithm>

namespace pyrasim {
namespace {

FirstHitRange of_skin(const QuadricRootRanges& roots, const StretchRanges& kept) {
  FirstHitRange first;
  for (const DistanceRange& root : {roots.first, roots.last}) {
    const bool possible = root.highest >= kept.begin.lowest && root.lowest <= kept.end.highest;
    const bool certain = root.lowest >= kept.begin.highest && root.highest <= kept.end.lowest;
    if (possible) first.add(root, roots.certain && certain);
  }
  return first;
}

}  // namespace

void FirstHitRange::add(const DistanceRange& range, bool certainly) {
  if (closed_ || !(range.highest > 0) || range.lowest == std::numeric_limits<double>::infinity()) return;
  range_ = {std::min(range_.lowest, std::max(range.lowest, 0.0)), std::max(range_.highest, range.highest)};
  closed_ = certainly && range.lowest > 0;
}

void FirstHitRange::add_stretch(const StretchRanges& stretch, bool certainly) {
  if (!stretch.possible()) return;
  const bool certain = certainly && stretch.certain();
  add(stretch.begin, certain);
  if (!(stretch.begin.lowest > 0)) add(stretch.end, certain);
}

FirstHitRange first_hit_range(const QuadricRootRanges& roots, const StretchRanges& kept, bool capped) {
  FirstHitRange first;
  if (roots.shapeless) {
    first.add({0, std::numeric_limits<double>::infinity()}, false);
    return first;
  }
  if (!capped) return roots.possible ? of_skin(roots, kept) : first;
  if (!roots.possible) {
    if (roots.inside_without_roots) first.add_stretch(kept, true);
    return first;
  }
  if (!roots.outside) {
    first.add_stretch({later(roots.first, kept.begin), earlier(roots.last, kept.end)}, roots.certain);
    return first;
  }
  first.add_stretch({kept.begin, earlier(roots.first, kept.end)}, roots.certain);
  first.add_stretch({later(roots.last, kept.begin), kept.end}, roots.certain);
  // Where there may be no roots, there may be no gap between these stretches, and the first one ends with the second.
  if (!roots.certain) first.add_stretch(kept, true);
  if (!roots.certain) first.add(kept.end, kept.certain());
  return first;
}

}  // namespace pyrasim
