// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <type_traits>

#include "trace/datapath_formats.h"
#include "trace/scene_tracer.h"
#include "trace/view_vector.h"

namespace pyrasim {

/// The sample at a grid point, its tests added to `work` and its arithmetic's events to `events`; SceneTracer<double>
/// has none.
template <class AnyTracer>
Sample trace_point(const AnyTracer& tracer, const ViewVectors& view_vectors, GridPoint point, Work& work,
                   DatapathEvents& events) {
  if constexpr (std::is_same_v<AnyTracer, SceneTracer<double>>) {
    return tracer.trace(view_vectors(point), work);
  } else {
    const glm::dvec3 view_vector = counting_events(events.view_vectors, [&] { return view_vectors(point); });
    return counting_events(events.intersection, [&] { return tracer.trace(view_vector, work); });
  }
}

}  // namespace pyrasim
