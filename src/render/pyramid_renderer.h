// SPDX-License-Identifier: Apache-2.0
// The reference renderer: the method without time, written to be read beside docs/method.md.
#pragma once

#include "image/image.h"
#include "intersect/scene_intersector.h"
#include "pyramid/terminal_color.h"
#include "render/cost_maps.h"
#include "render/frame_statistics.h"
#include "render/parallel.h"

namespace pyrasim {

/// Which points of a subdivision are traced again (decision D3). Pictures are the same under all three.
enum class Reuse : std::uint8_t {
  none,   ///< all five, as in the article's pseudo-code
  pixel,  ///< each point of a pixel's grid once
  frame,  ///< also each point on the sides between pixels once
};

struct PyramidOptions {
  int max_level = 3;  ///< 0 to max_level_limit
  EdgePolicy edge = EdgePolicy::mean;
  Reuse reuse = Reuse::none;
  int threads = 0;                 ///< 0: one for each core. Results do not depend on it
  NumberFormat view_vectors = {};  ///< the format of view vectors
  TextureFilter texture = TextureFilter::integral;
  CostMaps* maps = nullptr;  ///< of the window, to be filled; they outlive the rendering
};

struct Rendering {
  Image image;
  FrameStatistics statistics;
};

/// Renders the scene on its camera's screen, or on the window of it. Requires addressable(columns, rows, max_level).
/// AnyIntersector: Intersector, or SceneIntersector<double> for speed.
template <class AnyIntersector>
Rendering render_pyramids(const Scene& scene, const AnyIntersector& intersector, const PyramidOptions& options,
                          const Progress& progress = {});

extern template Rendering render_pyramids(const Scene&, const SceneIntersector<double>&, const PyramidOptions&,
                                          const Progress&);
extern template Rendering render_pyramids(const Scene&, const Intersector&, const PyramidOptions&, const Progress&);

}  // namespace pyrasim
