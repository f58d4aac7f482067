// SPDX-License-Identifier: Apache-2.0
// The renderer's kernels, in Google Benchmark: cost per ray on the shipped scenes, and what a frame takes.
#include <benchmark/benchmark.h>

#include "render/pyramid_renderer.h"
#include "scene/load_scene.h"

namespace {

using namespace pyrasim;

Scene shipped(const char* name) { return load_scene(std::string(PYRASIM_SOURCE_DIR) + "/scenes/" + name + ".json"); }

/// One primary ray after the other in raster order; the counter is rays per second.
template <class Scalar>
void trace(benchmark::State& state, const char* name) {
  const Scene scene = shipped(name);
  const SceneTracer<Scalar> tracer(scene);
  const ViewVectors<Scalar> view_vectors(scene.camera.screen, 1);
  Work work;
  GridPoint point;
  for (auto _ : state) {
    benchmark::DoNotOptimize(tracer.trace(view_vectors(point), work));
    if (++point.column > static_cast<std::uint32_t>(scene.camera.screen.columns)) {
      point.column = 0;
      if (++point.row > static_cast<std::uint32_t>(scene.camera.screen.rows)) point.row = 0;
    }
  }
  state.counters["rays"] = benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

void trace_double(benchmark::State& state, const char* name) { trace<double>(state, name); }
void trace_float(benchmark::State& state, const char* name) { trace<float>(state, name); }

/// A whole frame; arguments: MAX_LEVEL and threads.
void frame(benchmark::State& state, const char* name) {
  const Scene scene = shipped(name);
  const SceneTracer<double> tracer(scene);
  const PyramidOptions options{static_cast<int>(state.range(0)), Leaf::mean, Reuse::none,
                               static_cast<int>(state.range(1))};
  std::uint64_t rays = 0;
  for (auto _ : state) rays += render_pyramids(scene, tracer, options).statistics.total_rays();
  state.counters["rays"] = benchmark::Counter(static_cast<double>(rays), benchmark::Counter::kIsRate);
}

/// From the loaded scene to one that is ready to be traced: the hierarchy, mostly.
void prepare(benchmark::State& state, const char* name) {
  const Scene scene = shipped(name);
  for (auto _ : state) benchmark::DoNotOptimize(prepare_scene<double>(scene).root);
}

BENCHMARK_CAPTURE(trace_double, keel, "keel");
BENCHMARK_CAPTURE(trace_double, spheres, "spheres");
BENCHMARK_CAPTURE(trace_double, fins, "fins");
BENCHMARK_CAPTURE(trace_double, bunny, "bunny");
BENCHMARK_CAPTURE(trace_float, spheres, "spheres");
BENCHMARK_CAPTURE(trace_float, bunny, "bunny");
BENCHMARK_CAPTURE(frame, spheres, "spheres")
    ->ArgsProduct({{0, 3}, {1, 2}})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(frame, bunny, "bunny")->ArgsProduct({{0, 3}, {1, 2}})->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(prepare, bunny, "bunny")->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
