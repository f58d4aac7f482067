// SPDX-License-Identifier: Apache-2.0
#include "render/pyramid_renderer.h"

#include <atomic>
#include <mutex>
#include <vector>

#include "pyramid/trace_tree.h"
#include "render/sample_at.h"
#include "render/sample_cache.h"

namespace pyrasim {
namespace {

constexpr int band_rows = 8;

/// What two neighbouring bands of pixel rows share: the corner samples of the row of corners between them, and the
/// points on that line that the upper band's subdivisions traced.
struct Seam {
  enum class State { awaited, ready, abandoned };

  std::vector<Sample> corners;
  SampleCache border;
  std::atomic<State> state{State::awaited};

  /// Once; what comes later is of no account.
  void settle(State to) {
    State from = State::awaited;
    state.compare_exchange_strong(from, to);
    state.notify_all();
  }

  /// Whether it has been handed over, and not abandoned.
  bool wait() const {
    state.wait(State::awaited);
    return state == State::ready;
  }
};

/// What all threads read, and the seams by which they hand over.
template <class AnyIntersector>
struct Frame {
  const AnyIntersector& intersector;
  const PyramidOptions& options;
  Palette palette;
  ViewVectors view_vectors;
  PixelWindow window;
  Image image;
  std::vector<Seam> seams;  ///< seams[b] lies above band b
  std::mutex totals;
  FrameStatistics statistics;
};

/// Renders bands of rows; one for each thread.
template <class AnyIntersector>
class BandWorker {
 public:
  explicit BandWorker(Frame<AnyIntersector>& frame) : frame_(frame), max_level_(frame.options.max_level) {}
  BandWorker(const BandWorker&) = delete;
  BandWorker& operator=(const BandWorker&) = delete;
  ~BandWorker() {
    const std::scoped_lock lock(frame_.totals);
    frame_.statistics += statistics_;
  }

  /// Whether the band is done or not, the one below does not wait for ever.
  void operator()(int band) {
    try {
      render_band(band);
    } catch (...) {
      seam_below(band).settle(Seam::State::abandoned);
      throw;
    }
  }

 private:
  Seam& seam_below(int band) { return frame_.seams[static_cast<std::size_t>(band) + 1]; }

  /// Band `band`'s first row comes last: it needs the seam that the band above leaves behind.
  void render_band(int band) {
    first_row_ = band * band_rows;
    const int rows = std::min(band_rows, frame_.window.rows - first_row_);
    if (band == 0) sample_corner_row(0);
    for (int k = 0; k <= rows; ++k) borders_[k].clear();
    sample_corner_row(1);
    if (band == 0) render_row(0);
    for (int k = 1; k < rows; ++k) {
      sample_corner_row(k + 1);
      render_row(k);
    }
    if (band > 0 && rows > 1) hand_over(band, rows);
    if (band > 0) {
      Seam& above = frame_.seams[static_cast<std::size_t>(band)];
      if (!above.wait()) return seam_below(band).settle(Seam::State::abandoned);
      corners_[0] = std::move(above.corners);
      borders_[0] = std::move(above.border);
      render_row(0);
    }
    if (band == 0 || rows == 1) hand_over(band, rows);
  }

  void hand_over(int band, int row) {
    Seam& below = seam_below(band);
    below.corners = std::move(corners_[row]);
    below.border = std::move(borders_[row]);
    below.settle(Seam::State::ready);
  }

  Sample trace(GridPoint point) {
    return sample_at(frame_.intersector, frame_.view_vectors, point, statistics_.work, statistics_.arithmetic);
  }

  /// Corners of row first_row_ + k: each traced once, however many pixels share it.
  void sample_corner_row(int k) {
    auto& corners = corners_[k];
    corners.resize(static_cast<std::size_t>(frame_.window.columns) + 1);
    GridPoint point = pixel_cell(frame_.window, static_cast<std::uint32_t>(first_row_ + k), 0, max_level_).corner;
    for (Sample& corner : corners) {
      corner = trace(point);
      point.column += 1U << max_level_;
    }
    statistics_.rays_by_level[0] += corners.size();
  }

  void render_row(int k) {
    const auto& above = corners_[k];
    const auto& below = corners_[k + 1];
    vertical_border_.clear();
    border_above_ = &borders_[k];
    border_below_ = &borders_[k + 1];
    for (int column = 0; column < frame_.window.columns; ++column) {
      const auto nu = static_cast<std::size_t>(column);
      pixel_ = pixel_cell(frame_.window, static_cast<std::uint32_t>(first_row_ + k), static_cast<std::uint32_t>(nu),
                          max_level_);
      frame_.image.at(first_row_ + k, column) = render_pixel({above[nu], above[nu + 1], below[nu], below[nu + 1]});
    }
  }

  /// The article's render: a pixel's four corners decide its case.
  glm::vec3 render_pixel(const CornerSamples& corners) {
    const PyramidCase which = classify(corners);
    statistics_.count(which, 0);
    if (!subdivides(which, pixel_)) {
      count_terminal_node(which, pixel_.log2_side);
      return single_node_result(
          frame_.palette.terminal_color(which, corners, frame_.options.edge, pixel_, statistics_.texture));
    }
    interior_.clear();
    TraceTree tree;
    pixel_subdivision(pixel_, corners, tree);
    return tree.result(max_level_);
  }

  /// Five more rays split a case-3 pyramid in four.
  void pixel_subdivision(const Cell& cell, const CornerSamples& corners, TraceTree& tree) {
    ++statistics_.subdivisions;
    SubdivisionSamples middle;
    for (std::size_t k = 0; k < subdivision_rays; ++k) {
      middle[k] = subdivision_sample(subdivision_point(cell, k), level_of(cell.log2_side - 1, max_level_));
    }
    for (std::size_t child = 0; child < 4; ++child) {
      subpixel_check(subpixel(cell, child), subpixel_corners(corners, middle, child), tree);
    }
  }

  void subpixel_check(const Cell& subpixel, const CornerSamples& corners, TraceTree& tree) {
    const PyramidCase which = classify(corners);
    statistics_.count(which, level_of(subpixel.log2_side, max_level_));
    if (subdivides(which, subpixel)) {
      pixel_subdivision(subpixel, corners, tree);
      return;
    }
    count_terminal_node(which, subpixel.log2_side);
    tree.add_terminal_node(subpixel.log2_side, frame_.palette.terminal_color(which, corners, frame_.options.edge,
                                                                             subpixel, statistics_.texture));
  }

  void count_terminal_node(PyramidCase which, std::uint32_t log2_side) {
    ++statistics_.terminal_nodes;
    if (frame_.options.maps == nullptr) return;
    const auto row = static_cast<int>(pixel_.corner.row >> max_level_) - frame_.window.row;
    const auto column = static_cast<int>(pixel_.corner.column >> max_level_) - frame_.window.column;
    frame_.options.maps->add_terminal_node(
        static_cast<std::size_t>(row) * static_cast<std::size_t>(frame_.window.columns) +
            static_cast<std::size_t>(column),
        which, log2_side);
  }

  /// The sample at one of the five points of a subdivision into subpixels of `level`: traced, or taken from an earlier
  /// subdivision where the policy allows. A point inside the pixel can only have been met in this pixel; a point on
  /// its sides only in the neighbour.
  Sample subdivision_sample(GridPoint point, std::uint32_t level) {
    const std::uint32_t down = point.row - pixel_.corner.row;
    const std::uint32_t right = point.column - pixel_.corner.column;
    const std::uint32_t end = 1U << max_level_;
    const bool inside = down != 0 && down != end && right != 0 && right != end;
    SampleCache& cache = inside        ? interior_
                         : down == 0   ? *border_above_
                         : down == end ? *border_below_
                                       : vertical_border_;
    const auto [sample, fresh] = cache.insert(point);
    if (!fresh) {
      ++(inside ? statistics_.repeated_in_pixel : statistics_.repeated_between_pixels);
      if (frame_.options.reuse == Reuse::frame || (inside && frame_.options.reuse == Reuse::pixel)) return *sample;
    }
    ++statistics_.rays_by_level[level];
    *sample = trace(point);
    return *sample;
  }

  Frame<AnyIntersector>& frame_;
  const int max_level_;
  FrameStatistics statistics_;
  int first_row_ = 0;  ///< of the band, inside the window
  Cell pixel_;         ///< the current one
  std::array<std::vector<Sample>, band_rows + 1> corners_;
  std::array<SampleCache, band_rows + 1> borders_;  ///< points on the lines between rows of pixels
  SampleCache* border_above_ = nullptr;
  SampleCache* border_below_ = nullptr;
  SampleCache vertical_border_;  ///< points on the lines between the pixels of a row
  SampleCache interior_;         ///< points inside the pixel
};

}  // namespace

template <class AnyIntersector>
Rendering render_pyramids(const Scene& scene, const AnyIntersector& intersector, const PyramidOptions& options,
                          const Progress& progress) {
  const Screen& screen = scene.camera.screen;
  const PixelWindow window = scene.camera.rendered();
  const int bands = (window.rows + band_rows - 1) / band_rows;
  Frame<AnyIntersector> frame{
      .intersector = intersector,
      .options = options,
      .palette = Palette(scene, std::int64_t{1} << options.max_level, options.texture),
      .view_vectors = ViewVectors(screen, std::int64_t{1} << options.max_level, options.view_vectors),
      .window = window,
      .image = Image(window.columns, window.rows),
      .seams = std::vector<Seam>(static_cast<std::size_t>(bands) + 1),
      .totals = {},
      .statistics = {}};
  frame.statistics.lights_with_shadows = intersector.contents().lights_with_shadows;
  run_tasks<BandWorker<AnyIntersector>>(bands, thread_count(options.threads), progress, frame);
  return {std::move(frame.image), frame.statistics};
}

template Rendering render_pyramids(const Scene&, const SceneIntersector<double>&, const PyramidOptions&,
                                   const Progress&);
template Rendering render_pyramids(const Scene&, const Intersector&, const PyramidOptions&, const Progress&);

}  // namespace pyrasim
