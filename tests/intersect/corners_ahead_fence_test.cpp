// SPDX-License-Identifier: Apache-2.0
// The look-ahead thread writes over no row that may still be asked for: corners asked for as late as it is allowed.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>

#include "intersect/corners_ahead.h"

namespace pyrasim {
namespace {

/// A screen whose view vectors tell rows and columns exactly.
Screen screen_of(const PixelWindow& window) { return {window.columns, window.rows, 1, 1, 1}; }

/// Every corner is an object of its own, and is its column's number of box tests. The look-ahead thread can be halted.
class NumberedTracer final : public Intersector {
 public:
  explicit NumberedTracer(const PixelWindow& window, std::uint32_t halt_row = no_object)
      : window_(window), halt_row_(halt_row) {}

  Sample intersect(const glm::dvec3& view_vector, Work& work) const override {
    const auto row = static_cast<std::uint32_t>(window_.rows / 2.0 - view_vector.y);
    const auto column = static_cast<std::uint32_t>(view_vector.z + window_.columns / 2.0);
    if (std::this_thread::get_id() != asker_) {
      if (row == halt_row_) {
        halted_ = true;
        halted_.notify_one();
        released_.wait(false);
      }
      ++rays_ahead_;
      if (rays_ahead_ % 97 == 0) std::this_thread::yield();
    }
    return sample_of(row, column, work);
  }
  SceneContents contents() const override { return {}; }

  Sample sample_of(std::uint32_t row, std::uint32_t column, Work& work) const {
    work.box_tests += column;
    ++work.surface_tests[row % surface_kinds];
    return {{row * static_cast<std::uint32_t>(window_.columns + 1) + column}, 1.0 / (1 + column)};
  }
  /// Waits until the thread comes to the row at which it halts: it has done those before.
  void await_halt() const { halted_.wait(false); }
  void release() {
    released_ = true;
    released_.notify_one();
  }
  std::size_t rays_ahead() const { return rays_ahead_; }
  /// Leaves the thread time to go where it should not.
  void await_rest() const {
    std::size_t before = 0;
    do {
      before = rays_ahead_;
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    } while (rays_ahead_ != before);
  }

 private:
  PixelWindow window_;
  std::uint32_t halt_row_;
  std::thread::id asker_ = std::this_thread::get_id();
  mutable std::atomic<bool> halted_{false};
  std::atomic<bool> released_{false};
  mutable std::atomic<std::size_t> rays_ahead_{0};
};

void expect_corner(CornersAhead& ahead, const NumberedTracer& intersector, const ViewVectors& view_vectors,
                   GridPoint point) {
  Work work;
  Work expected_work;
  const Sample sample = ahead.trace(point, view_vectors(point), work);
  ASSERT_EQ(sample, intersector.sample_of(point.row, point.column, expected_work)) << point.row << " " << point.column;
  ASSERT_EQ(work, expected_work) << point.row << " " << point.column;
}

/// Row 1 is open when the first corner of the furthest row is asked for that one of row 1 may follow. That row is not
/// there yet, so row 1 stays open: what is left of it is read as it lies, while the thread goes on as far as it may.
TEST(CornersAhead, KeepARowForAsLongAsItMayBeAskedFor) {
  constexpr PixelWindow window{0, 0, 7, 3000};
  constexpr std::uint32_t width = window.columns + 1;
  const ViewVectors view_vectors(screen_of(window), 1);
  for (const std::uint32_t rows_between : {1, 2, 5}) {
    const std::uint32_t furthest = 1 + rows_between;
    NumberedTracer intersector(window, furthest);
    CornersAhead ahead(intersector, view_vectors, window, 1, rows_between * width - 1);
    const auto ask = [&](std::uint32_t row, std::uint32_t first, std::uint32_t last) {
      for (std::uint32_t column = first; column <= last; ++column) {
        expect_corner(ahead, intersector, view_vectors, {row, column});
      }
    };
    intersector.await_halt();
    ask(0, 0, width - 1);
    ask(1, 0, 0);
    ask(furthest, 0, 0);
    intersector.release();
    intersector.await_rest();
    EXPECT_LT(intersector.rays_ahead(), std::size_t{width} * window.rows) << "there is a fence";
    ask(1, 1, width - 1);
    for (std::uint32_t row = 2; row <= static_cast<std::uint32_t>(window.rows); ++row) {
      ask(row, row == furthest ? 1 : 0, width - 1);
    }
  }
}

/// Blocks of the raster, each from its last corner to its first: every first corner is asked for as late as allowed.
TEST(CornersAhead, AtTheTightestUnderStress) {
  for (const PixelWindow& window :
       std::vector<PixelWindow>{{0, 0, 1, 2000}, {0, 0, 7, 1000}, {0, 0, 63, 200}, {0, 0, 1500, 20}}) {
    const auto width = static_cast<std::size_t>(window.columns) + 1;
    const std::size_t corners = width * (static_cast<std::size_t>(window.rows) + 1);
    const ViewVectors view_vectors(screen_of(window), 1);
    for (const std::size_t out_of_order : {std::size_t{1}, width - 1, width, width + 1, 3 * width - 1, 3 * width + 1}) {
      const NumberedTracer intersector(window);
      CornersAhead ahead(intersector, view_vectors, window, 1, out_of_order);
      for (std::size_t block = 0; block < corners; block += out_of_order + 1) {
        for (std::size_t corner = std::min(block + out_of_order + 1, corners); corner-- > block;) {
          expect_corner(ahead, intersector, view_vectors,
                        {static_cast<std::uint32_t>(corner / width), static_cast<std::uint32_t>(corner % width)});
          if (HasFatalFailure()) return;
        }
        if (block % 64 == 0) std::this_thread::yield();
      }
    }
  }
}

}  // namespace
}  // namespace pyrasim
