// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <type_traits>

#include "camera/view_vector.h"
#include "intersect/datapath_formats.h"
#include "intersect/scene_intersector.h"

namespace pyrasim {

/// The sample at a grid point, its tests added to `work` and its arithmetic's events to `events`;
/// SceneIntersector<double> has none.
template <class AnyIntersector>
Sample sample_at(const AnyIntersector& intersector, const ViewVectors& view_vectors, GridPoint point, Work& work,
                 DatapathEvents& events) {
  if constexpr (std::is_same_v<AnyIntersector, SceneIntersector<double>>) {
    return intersector.intersect(view_vectors(point), work);
  } else {
    const glm::dvec3 view_vector = counting_events(events.view_vectors, [&] { return view_vectors(point); });
    return counting_events(events.intersection, [&] { return intersector.intersect(view_vector, work); });
  }
}

}  // namespace pyrasim
