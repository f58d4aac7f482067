// SPDX-License-Identifier: Apache-2.0
#include "study/decision_flips.h"

#include <algorithm>
#include <mutex>
#include <vector>

#include "pyramid/classifier.h"

namespace pyrasim {
namespace {

/// One of the two datapaths, on the frame's grid.
struct Side {
  const Intersector& intersector;
  ViewVectors view_vectors;

  Sample sample(GridPoint point) const {
    Work work;
    return intersector.intersect(view_vectors(point), work);
  }

  std::vector<Sample> corner_row(std::uint32_t row, int columns, int max_level) const {
    std::vector<Sample> samples(static_cast<std::size_t>(columns) + 1);
    for (std::uint32_t column = 0; column < samples.size(); ++column) {
      samples[column] = sample({row << max_level, column << max_level});
    }
    return samples;
  }
};

struct Comparison {
  Side reference;
  Side studied;
  int columns;
  int rows;
  int max_level;
  std::mutex totals;
  DecisionFlips flips;
};

constexpr int band_rows = 16;

/// Compares bands of rows; one for each thread.
class BandComparison {
 public:
  explicit BandComparison(Comparison& comparison) : its_(comparison) {}
  BandComparison(const BandComparison&) = delete;
  BandComparison& operator=(const BandComparison&) = delete;
  ~BandComparison() {
    const std::scoped_lock lock(its_.totals);
    its_.flips += flips_;
  }

  void operator()(int band) {
    const int first = band * band_rows;
    const int last = std::min(first + band_rows, its_.rows);
    CornerRows above = trace(first);
    for (int row = first; row < last; ++row) {
      CornerRows below = trace(row + 1);
      compare_row(static_cast<std::uint32_t>(row), above, below);
      above = std::move(below);
    }
  }

 private:
  struct CornerRows {
    std::vector<Sample> reference;
    std::vector<Sample> studied;
  };

  CornerRows trace(int row) const {
    const auto number = static_cast<std::uint32_t>(row);
    return {its_.reference.corner_row(number, its_.columns, its_.max_level),
            its_.studied.corner_row(number, its_.columns, its_.max_level)};
  }

  void compare_row(std::uint32_t row, const CornerRows& above, const CornerRows& below) {
    for (std::uint32_t k = 0; k < static_cast<std::uint32_t>(its_.columns); ++k) {
      const auto corners = [k](const std::vector<Sample>& upper, const std::vector<Sample>& lower) {
        return CornerSamples{upper[k], upper[k + 1], lower[k], lower[k + 1]};
      };
      const CornerSamples reference = corners(above.reference, below.reference);
      const CornerSamples studied = corners(above.studied, below.studied);
      compare(pixel_cell({}, row, k, its_.max_level), &reference, &studied);
    }
  }

  /// A pyramid that both come to, or only one; the other is none then.
  void compare(const Cell& cell, const CornerSamples* reference, const CornerSamples* studied) {
    if (reference != nullptr && studied != nullptr) {
      ++flips_.decisions;
      if (differ(*reference, *studied)) ++flips_.flipped;
    }
    const bool reference_splits = splits(cell, reference);
    const bool studied_splits = splits(cell, studied);
    if (studied_splits && !reference_splits) ++flips_.extra_subdivisions;
    if (reference_splits && !studied_splits) ++flips_.lost_subdivisions;
    if (!reference_splits && !studied_splits) return;
    SubdivisionSamples reference_middle;
    SubdivisionSamples studied_middle;
    for (std::size_t k = 0; k < subdivision_rays; ++k) {
      const GridPoint point = subdivision_point(cell, k);
      if (reference_splits) reference_middle[k] = its_.reference.sample(point);
      if (studied_splits) studied_middle[k] = its_.studied.sample(point);
    }
    for (std::size_t child = 0; child < 4; ++child) {
      CornerSamples reference_corners;
      CornerSamples studied_corners;
      if (reference_splits) reference_corners = subpixel_corners(*reference, reference_middle, child);
      if (studied_splits) studied_corners = subpixel_corners(*studied, studied_middle, child);
      compare(subpixel(cell, child), reference_splits ? &reference_corners : nullptr,
              studied_splits ? &studied_corners : nullptr);
    }
  }

  static bool differ(const CornerSamples& a, const CornerSamples& b) {
    const PyramidCase which = classify(a);
    return which != classify(b) || (which == PyramidCase::covered && a[0].seen != b[0].seen);
  }

  static bool splits(const Cell& cell, const CornerSamples* corners) {
    return corners != nullptr && subdivides(classify(*corners), cell);
  }

  Comparison& its_;
  DecisionFlips flips_;
};

}  // namespace

DecisionFlips decision_flips(const Scene& scene, const StudiedDatapath& reference, const StudiedDatapath& studied,
                             int max_level, int threads) {
  const Screen& screen = scene.camera.screen;
  const auto side = [&](const StudiedDatapath& datapath) {
    return Side{datapath.intersector, ViewVectors(screen, std::int64_t{1} << max_level, datapath.view_vectors)};
  };
  Comparison comparison{side(reference), side(studied), screen.columns, screen.rows, max_level, {}, {}};
  run_tasks<BandComparison>((screen.rows + band_rows - 1) / band_rows, thread_count(threads), {}, comparison);
  return comparison.flips;
}

}  // namespace pyrasim
