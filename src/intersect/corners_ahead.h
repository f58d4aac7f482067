// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <thread>
#include <vector>

#include "camera/view_vector.h"
#include "intersect/intersector.h"

namespace pyrasim {

/// Traces the corners of the raster (of the window that is rendered), row by row, on a thread of its own before
/// somebody asks for them: which corners a frame needs is known from the start. Whoever asks for a corner that the
/// thread has not come to traces it himself, so that a busy machine loses nothing. Results and work are those of
/// Intersector::intersect either way.
class CornersAhead {
 public:
  /// The thread starts at once. `out_of_order`: a corner is asked for at most so many corners after another one that
  /// follows it in the raster. Corners are `steps` grid steps apart, a power of two. `intersector` must
  /// outlive this.
  CornersAhead(const Intersector& intersector, const ViewVectors& view_vectors, const PixelWindow& window,
               std::uint32_t steps, std::size_t out_of_order);
  ~CornersAhead();
  CornersAhead(const CornersAhead&) = delete;
  CornersAhead& operator=(const CornersAhead&) = delete;

  /// The nearest hit through the corner `point`, whose view vector is `view_vector`. Adds the tests made to `work`. To
  /// be called from one thread, once for each corner, rows and columns ascending but for `out_of_order`.
  Sample trace(GridPoint point, const glm::dvec3& view_vector, Work& work);

 private:
  /// A sample and its work in one cache line: it is read by another core than wrote it.
  struct alignas(64) Corner {
    Sample sample;
    std::uint32_t box_tests;
    std::array<std::uint32_t, surface_kinds> surface_tests;
  };
  struct Row {
    std::atomic<std::int64_t> number{-1};  ///< of the row of corners that is here, complete; -1: none
    std::vector<Corner> corners;           ///< and some unused ones behind, to be fetched in vain
    std::vector<ShadowWork> shadows;       ///< of each corner; empty where no light has shadows
  };

  void run();
  void trace_row(std::int64_t number);
  /// Makes the row `number` the open one, if it is complete.
  bool open_row(std::int64_t number);
  /// The row that the thread may not yet begin: it takes the place of one that may still be asked for.
  std::int64_t first_barred() const;

  const Intersector& intersector_;
  ViewVectors view_vectors_;
  std::uint32_t steps_;
  int log2_steps_;
  GridPoint first_;  ///< the window's upper left corner; rows of corners count from it
  std::int64_t rows_;
  std::int64_t overlap_;                 ///< rows before the newest asked for that may still be asked for
  std::vector<Row> kept_;                ///< a ring
  std::atomic<std::int64_t> newest_{0};  ///< row asked for; past all rows to stop
  std::int64_t open_number_ = -1;        ///< of the row that was read last, while it was complete
  const Row* open_row_ = nullptr;
  std::jthread thread_;
};

}  // namespace pyrasim
