// SPDX-License-Identifier: Apache-2.0
// The peers: what pyramids are measured against.
#pragma once

#include <cstdint>

#include "render/pyramid_renderer.h"

namespace pyrasim {

/// N x N rays a pixel. `jitter` moves each at random inside its cell of the N x N grid; without it they go through the
/// cells' centres. N = 1 without jitter is point sampling (1).
struct BaselineOptions {
  int grid = 1;  ///< N, 1 to max_sampling_grid
  bool jitter = false;
  std::uint64_t seed = 1;
  int threads = 0;
  NumberFormat view_vectors = {};  ///< the format of view vectors
};

inline constexpr int max_sampling_grid = 256;

/// Grid steps along a pixel's side: the rays go through points of that grid, the centres of cells among them.
std::int64_t baseline_steps(const BaselineOptions& options);

/// Renders by regular or jittered supersampling: a pixel is the plain mean of its samples. All rays count as primary.
template <class AnyIntersector>
Rendering render_baseline(const Scene& scene, const AnyIntersector& intersector, const BaselineOptions& options,
                          const Progress& progress = {});

extern template Rendering render_baseline(const Scene&, const SceneIntersector<double>&, const BaselineOptions&,
                                          const Progress&);
extern template Rendering render_baseline(const Scene&, const Intersector&, const BaselineOptions&, const Progress&);

}  // namespace pyrasim
