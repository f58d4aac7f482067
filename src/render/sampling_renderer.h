// SPDX-License-Identifier: Apache-2.0
// The peers: what pyramids are measured against.
#pragma once

#include <cstdint>

#include "render/pyramid_renderer.h"

namespace pyrasim {

/// N x N rays a pixel. `jitter` moves each at random inside its cell of the N x N grid; without it they go through the
/// cells' centres. N = 1 without jitter is point sampling (1).
struct SamplingOptions {
  int grid = 1;  ///< N, 1 to max_sampling_grid
  bool jitter = false;
  std::uint64_t seed = 1;
  int threads = 0;
  NumberFormat view_vectors = {};  ///< the format of view vectors
};

inline constexpr int max_sampling_grid = 256;

/// Grid steps along a pixel's side: the rays go through points of that grid, the centres of cells among them.
std::int64_t sampling_steps(const SamplingOptions& options);

/// Renders by regular or jittered supersampling: a pixel is the plain mean of its samples. All rays count as primary.
template <class AnyTracer>
Rendering render_samples(const Scene& scene, const AnyTracer& tracer, const SamplingOptions& options,
                         const Progress& progress = {});

extern template Rendering render_samples(const Scene&, const SceneTracer<double>&, const SamplingOptions&,
                                         const Progress&);
extern template Rendering render_samples(const Scene&, const Tracer&, const SamplingOptions&, const Progress&);

}  // namespace pyrasim
