// SPDX-License-Identifier: Apache-2.0
#include "intersect/corners_ahead.h"

#include <algorithm>
#include <bit>
#include <system_error>

namespace pyrasim {
namespace {

/// The thread keeps ahead by as many corners, and by as many rows at least.
constexpr std::int64_t corners_ahead = 4096;
constexpr std::int64_t least_rows_ahead = 4;
/// Another core has written them: it takes long until they are here.
constexpr std::size_t corners_fetched_ahead = 16;

}  // namespace

CornersAhead::CornersAhead(const Intersector& intersector, const ViewVectors& view_vectors, const PixelWindow& window,
                           std::uint32_t steps, std::size_t out_of_order)
    : intersector_(intersector),
      view_vectors_(view_vectors),
      steps_(steps),
      log2_steps_(std::countr_zero(steps)),
      first_{static_cast<std::uint32_t>(window.row) * steps, static_cast<std::uint32_t>(window.column) * steps},
      rows_(window.rows + 1),
      overlap_(static_cast<std::int64_t>(out_of_order) / (window.columns + 1) + 1),
      kept_(static_cast<std::size_t>(overlap_ + std::max(corners_ahead / (window.columns + 1), least_rows_ahead))) {
  const std::size_t corners = static_cast<std::size_t>(window.columns) + 1;
  const bool has_shadows = intersector.contents().lights_with_shadows > 0;
  for (Row& row : kept_) {
    row.corners.resize(corners + corners_fetched_ahead);
    if (has_shadows) row.shadows.resize(corners);
  }
  try {
    thread_ = std::jthread([this] { run(); });
  } catch (const std::system_error&) {  // no thread to be had: all corners are traced by who asks
  }
}

CornersAhead::~CornersAhead() {
  newest_ = rows_ + overlap_;
  newest_.notify_one();
}

std::int64_t CornersAhead::first_barred() const { return newest_ - overlap_ + static_cast<std::int64_t>(kept_.size()); }

void CornersAhead::run() {
  for (std::int64_t row = 0; row < rows_; ++row) {
    std::int64_t newest = newest_;
    while (row >= first_barred()) {
      newest_.wait(newest);
      newest = newest_;
    }
    row = std::max(row, newest + 1);  // earlier ones are being traced by who asked
    if (row < rows_) trace_row(row);
  }
}

void CornersAhead::trace_row(std::int64_t number) {
  Row& row = kept_[static_cast<std::size_t>(number) % kept_.size()];
  row.number = -1;
  GridPoint point{first_.row + static_cast<std::uint32_t>(number) * steps_, first_.column};
  for (std::size_t k = 0; k + corners_fetched_ahead < row.corners.size(); ++k) {
    Corner& corner = row.corners[k];
    Work work;
    const Sample sample = intersector_.intersect(view_vectors_(point), work);
    corner = {sample, static_cast<std::uint32_t>(work.box_tests), {}};
    for (std::size_t kind = 0; kind < surface_kinds; ++kind) {
      corner.surface_tests[kind] = static_cast<std::uint32_t>(work.surface_tests[kind]);
    }
    if (!row.shadows.empty()) row.shadows[k] = work.shadow;
    point.column += steps_;
  }
  row.number = number;
}

bool CornersAhead::open_row(std::int64_t number) {
  if (number > newest_.load(std::memory_order_relaxed)) {
    newest_ = number;
    newest_.notify_one();
  }
  const Row& row = kept_[static_cast<std::size_t>(number) % kept_.size()];
  if (row.number.load(std::memory_order_acquire) != number) return false;
  open_number_ = number;
  open_row_ = &row;
  return true;
}

Sample CornersAhead::trace(GridPoint point, const glm::dvec3& view_vector, Work& work) {
  const std::int64_t number = (point.row - first_.row) >> log2_steps_;
  if (number != open_number_ && !open_row(number)) return intersector_.intersect(view_vector, work);
  const std::size_t column = (point.column - first_.column) >> log2_steps_;
  const Corner& corner = open_row_->corners[column];
  __builtin_prefetch(&corner + corners_fetched_ahead);
  work.box_tests += corner.box_tests;
  for (std::size_t kind = 0; kind < surface_kinds; ++kind) work.surface_tests[kind] += corner.surface_tests[kind];
  if (!open_row_->shadows.empty()) [[unlikely]]
    work.shadow += open_row_->shadows[column];
  return corner.sample;
}

}  // namespace pyrasim
