// SPDX-License-Identifier: Apache-2.0
// The renderer's kernels, in Google Benchmark: cost per ray on the shipped scenes, and what a frame takes.
#include <benchmark/benchmark.h>

#include <array>
#include <random>

#include "../shipped_scene.h"
#include "camera/view_vector.h"
#include "intersect/scene_intersector.h"
#include "numeric/fix.h"
#include "numeric/flt.h"
#include "render/pyramid_renderer.h"

namespace {

using namespace pyrasim;

/// One primary ray after the other in raster order; the counter is rays per second.
template <class Scalar>
void trace(benchmark::State& state, const char* name) {
  const Scene scene = shipped_scene(name);
  const SceneIntersector<Scalar> intersector(scene);
  const ViewVectors view_vectors(scene.camera.screen, 1, FormatOf<Scalar>::value);
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
template <class Number>
void multiply_add(benchmark::State& state) {
  const auto a = random_operands<Number>(1);
  const auto b = random_operands<Number>(2);
  const auto c = random_operands<Number>(3);
  std::array<Number, operands> results;
  for (auto _ : state) {
    for (std::size_t k = 0; k < operands; ++k) results[k] = a[k] * b[k] + c[k];
    benchmark::DoNotOptimize(results.data());
    benchmark::ClobberMemory();
  }
  state.counters["each"] = benchmark::Counter(static_cast<double>(state.iterations()) * operands,
                                              benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

/// The same where each waits for the one before.
template <class Number>
void multiply_add_chain(benchmark::State& state) {
  const auto a = random_operands<Number>(1);
  const auto b = random_operands<Number>(2);
  Number x = a[0];
  for (auto _ : state) {
    for (std::size_t k = 0; k < operands; ++k) x = x * a[k] + b[k];
    benchmark::DoNotOptimize(x);
  }
  state.counters["each"] = benchmark::Counter(static_cast<double>(state.iterations()) * operands,
                                              benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

using Truncating = Fix<48, 20, Rounding::SC_TRN, Overflow::SC_WRAP>;

BENCHMARK(multiply_add<double>);
BENCHMARK(multiply_add<float>);
BENCHMARK(multiply_add<Fp16>);
BENCHMARK(multiply_add<Bf16>);
BENCHMARK(multiply_add<Tf32>);
BENCHMARK(multiply_add<Fp24>);
BENCHMARK(multiply_add<Flt<8, 24>>);
BENCHMARK(multiply_add<Flt<8, 25>>);
BENCHMARK(multiply_add<Fix<64, 12>>);
BENCHMARK(multiply_add<Fix<64, 28>>);
BENCHMARK(multiply_add<Fix<64, 32>>);
BENCHMARK(multiply_add<Fix<48, 20>>);
BENCHMARK(multiply_add<Fix<32, 16>>);
BENCHMARK(multiply_add<Truncating>);
BENCHMARK(multiply_add_chain<double>);
BENCHMARK(multiply_add_chain<Fp24>);
BENCHMARK(multiply_add_chain<Fix<64, 28>>);
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
