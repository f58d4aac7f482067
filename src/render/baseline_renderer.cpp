// SPDX-License-Identifier: Apache-2.0
#include "render/baseline_renderer.h"

#include <mutex>

#include "render/sample_at.h"

namespace pyrasim {
namespace {

/// Grid steps along the side of one cell of the N x N grid: an even number, so that the centre is a grid point.
std::uint32_t cell_steps(const BaselineOptions& options) { return options.jitter ? 1U << 8U : 2; }

/// Sixteen mixed bits (SplitMix64, Steele, Lea, Flood 2014) of a counter, so that no thread's order matters.
std::uint32_t random_bits(std::uint64_t seed, std::uint64_t counter) {
  std::uint64_t z = seed * 0xD1342543DE82EF95ULL + (counter + 1) * 0x9E3779B97F4A7C15ULL;
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
  return static_cast<std::uint32_t>((z ^ (z >> 31U)) >> 48U);
}

template <class AnyIntersector>
struct SamplingFrame {
  const AnyIntersector& intersector;
  const BaselineOptions& options;
  Palette palette;
  std::uint32_t cell_steps;  ///< grid steps along a cell's side
  ViewVectors view_vectors;
  PixelWindow window;
  Image image;
  std::mutex totals;
  Work work;
  TextureWork texture;
  DatapathEvents arithmetic;
};

template <class AnyIntersector>
class RowWorker {
 public:
  explicit RowWorker(SamplingFrame<AnyIntersector>& frame) : frame_(frame) {}
  RowWorker(const RowWorker&) = delete;
  RowWorker& operator=(const RowWorker&) = delete;
  ~RowWorker() {
    const std::scoped_lock lock(frame_.totals);
    frame_.work += work_;
    frame_.texture += texture_;
    frame_.arithmetic += arithmetic_;
  }

  void operator()(int row) {
    const PixelWindow& window = frame_.window;
    for (int column = 0; column < window.columns; ++column) {
      frame_.image.at(row, column) =
          pixel(static_cast<std::uint32_t>(window.row + row), static_cast<std::uint32_t>(window.column + column));
    }
  }

 private:
  /// The screen's pixel.
  glm::vec3 pixel(std::uint32_t row, std::uint32_t column) {
    const auto grid = static_cast<std::uint32_t>(frame_.options.grid);
    std::array<double, 3> sum{};
    for (std::uint32_t i = 0; i < grid; ++i) {
      for (std::uint32_t j = 0; j < grid; ++j) {
        const GridPoint point = sample_point(row * grid + i, column * grid + j);
        const Sample sample = sample_at(frame_.intersector, frame_.view_vectors, point, work_, arithmetic_);
        const FixedColor color = frame_.palette.sample_color(sample, point, texture_);
        for (std::size_t k = 0; k < 3; ++k) sum[k] += std::ldexp(static_cast<double>(color[k]), -fixed_color_bits);
      }
    }
    const double samples = static_cast<double>(grid) * grid;
    return {static_cast<float>(sum[0] / samples), static_cast<float>(sum[1] / samples),
            static_cast<float>(sum[2] / samples)};
  }

  /// A point in the cell at (cell_row, cell_column), counted over the whole screen.
  GridPoint sample_point(std::uint32_t cell_row, std::uint32_t cell_column) const {
    const std::uint32_t steps = frame_.cell_steps;
    if (!frame_.options.jitter) return {cell_row * steps + steps / 2, cell_column * steps + steps / 2};
    const std::uint64_t cell = (static_cast<std::uint64_t>(cell_row) << 32U) | cell_column;
    const std::uint32_t bits = random_bits(frame_.options.seed, cell);
    return {cell_row * steps + (bits & (steps - 1)), cell_column * steps + (bits >> 8U)};
  }

  SamplingFrame<AnyIntersector>& frame_;
  Work work_;
  TextureWork texture_;
  DatapathEvents arithmetic_;
};

}  // namespace

std::int64_t baseline_steps(const BaselineOptions& options) {
  return static_cast<std::int64_t>(options.grid) * cell_steps(options);
}

template <class AnyIntersector>
Rendering render_baseline(const Scene& scene, const AnyIntersector& intersector, const BaselineOptions& options,
                          const Progress& progress) {
  const PixelWindow window = scene.camera.rendered();
  SamplingFrame<AnyIntersector> frame{
      .intersector = intersector,
      .options = options,
      .palette = Palette(scene, baseline_steps(options)),
      .cell_steps = cell_steps(options),
      .view_vectors = ViewVectors(scene.camera.screen, baseline_steps(options), options.view_vectors),
      .window = window,
      .image = Image(window.columns, window.rows),
      .totals = {},
      .work = {},
      .texture = {},
      .arithmetic = {}};
  run_tasks<RowWorker<AnyIntersector>>(window.rows, thread_count(options.threads), progress, frame);
  Rendering rendering{std::move(frame.image), {}};
  rendering.statistics.rays_by_level[0] =
      static_cast<std::uint64_t>(window.rows) * static_cast<std::uint64_t>(window.columns) *
      static_cast<std::uint64_t>(options.grid) * static_cast<std::uint64_t>(options.grid);
  rendering.statistics.lights_with_shadows = intersector.contents().lights_with_shadows;
  rendering.statistics.work = frame.work;
  rendering.statistics.texture = frame.texture;
  rendering.statistics.arithmetic = frame.arithmetic;
  return rendering;
}

template Rendering render_baseline(const Scene&, const SceneIntersector<double>&, const BaselineOptions&,
                                   const Progress&);
template Rendering render_baseline(const Scene&, const Intersector&, const BaselineOptions&, const Progress&);

}  // namespace pyrasim
