// SPDX-License-Identifier: Apache-2.0
// The renderer's kernels, in Google Benchmark: cost per ray on the shipped scenes, and what a frame takes.
#include <benchmark/benchmark.h>

#include <array>
#include <random>

#include "../shipped_scene.h"
#include "camera/view_vector.h"
#include "intersect/scene_intersector.h"
#include "numeric/number_types.h"
#include "render/pyramid_renderer.h"

namespace {

using namespace pyrasim;

/// One primary ray after the other in raster order; the counter is rays per second.
template <class Scalar>
void trace(benchmark::State& state, const char* name) {
  const Scene scene = shipped_scene(name);
  const SceneIntersector<Scalar> intersector(scene);
  const ViewVectors view_vectors(scene.camera.screen, 1, format_of<Scalar>());
  Work work;
  GridPoint point;
  for (auto _ : state) {
    benchmark::DoNotOptimize(intersector.intersect(view_vectors(point), work));
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
  const Scene scene = shipped_scene(name);
  const SceneIntersector<double> intersector(scene);
  const PyramidOptions options{static_cast<int>(state.range(0)), EdgePolicy::mean, Reuse::none,
                               static_cast<int>(state.range(1))};
  std::uint64_t rays = 0;
  for (auto _ : state) rays += render_pyramids(scene, intersector, options).statistics.total_rays();
  state.counters["rays"] = benchmark::Counter(static_cast<double>(rays), benchmark::Counter::kIsRate);
}

/// From the loaded scene to one that is ready to be traced: the hierarchy, mostly.
void prepare(benchmark::State& state, const char* name) {
  const Scene scene = shipped_scene(name);
  for (auto _ : state) benchmark::DoNotOptimize(prepare_scene(scene, {}).root);
}

constexpr std::size_t operands = 1024;

template <class Number>
std::array<Number, operands> random_operands(unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> values(-1, 1);
  std::array<Number, operands> numbers;
  for (Number& number : numbers) number = static_cast<Number>(values(random));
  return numbers;
}

/// The number format's price: a * b + c for operands that do not wait for each other, and ns for each.
void multiply_add(benchmark::State& state, const char* format) {
  with_number_type(parse_number_format(format), [&]<class Number>(std::type_identity<Number>) {
    const auto a = random_operands<Number>(1);
    const auto b = random_operands<Number>(2);
    const auto c = random_operands<Number>(3);
    std::array<Number, operands> results;
    for (auto _ : state) {
      for (std::size_t k = 0; k < operands; ++k) results[k] = a[k] * b[k] + c[k];
      benchmark::DoNotOptimize(results.data());
      benchmark::ClobberMemory();
    }
  });
  state.counters["each"] = benchmark::Counter(static_cast<double>(state.iterations()) * operands,
                                              benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

/// The same where each waits for the one before.
void multiply_add_chain(benchmark::State& state, const char* format) {
  with_number_type(parse_number_format(format), [&]<class Number>(std::type_identity<Number>) {
    const auto a = random_operands<Number>(1);
    const auto b = random_operands<Number>(2);
    Number x = a[0];
    for (auto _ : state) {
      for (std::size_t k = 0; k < operands; ++k) x = x * a[k] + b[k];
      benchmark::DoNotOptimize(x);
    }
  });
  state.counters["each"] = benchmark::Counter(static_cast<double>(state.iterations()) * operands,
                                              benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

BENCHMARK_CAPTURE(multiply_add, double, "double");
BENCHMARK_CAPTURE(multiply_add, float, "float");
BENCHMARK_CAPTURE(multiply_add, fp16, "fp16");
BENCHMARK_CAPTURE(multiply_add, bf16, "bf16");
BENCHMARK_CAPTURE(multiply_add, tf32, "tf32");
BENCHMARK_CAPTURE(multiply_add, fp24, "fp24");
BENCHMARK_CAPTURE(multiply_add, e8p24, "e8p24");
BENCHMARK_CAPTURE(multiply_add, e8p25, "e8p25");
BENCHMARK_CAPTURE(multiply_add, fix64_12, "fix64.12");
BENCHMARK_CAPTURE(multiply_add, fix64_28, "fix64.28");
BENCHMARK_CAPTURE(multiply_add, fix64_32, "fix64.32");
BENCHMARK_CAPTURE(multiply_add, fix48_20, "fix48.20");
BENCHMARK_CAPTURE(multiply_add, fix32_16, "fix32.16");
BENCHMARK_CAPTURE(multiply_add_chain, double, "double");
BENCHMARK_CAPTURE(multiply_add_chain, fp24, "fp24");
BENCHMARK_CAPTURE(multiply_add_chain, fix64_28, "fix64.28");
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
