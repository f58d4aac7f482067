// SPDX-License-Identifier: Apache-2.0
#include "hw_model/record/point_table.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace pyrasim::hw {
namespace {

bool comes_before(GridPoint a, GridPoint b) { return std::tie(a.row, a.column) < std::tie(b.row, b.column); }

}  // namespace

PointTable::PointTable(const WorkTable& rows, const PixelWindow& window, int max_level)
    : log2_steps_(static_cast<unsigned>(max_level)),
      first_{static_cast<std::uint32_t>(window.row), static_cast<std::uint32_t>(window.column)},
      rows_(static_cast<std::uint32_t>(window.rows) + 1),
      columns_(static_cast<std::uint32_t>(window.columns) + 1),
      begin_(std::size_t{rows_} * columns_ + 1),
      table_(rows.columns()) {
  const auto for_each_row = [&](const auto& visit) {
    for (std::size_t k = 0; k < rows.rows(); ++k) {
      const std::size_t pixel = pixel_of(point_of(rows.row(k)));
      if (pixel + 1 < begin_.size()) visit(pixel, rows.row(k));
    }
  };
  for_each_row([&](std::size_t pixel, const std::uint32_t*) { ++begin_[pixel + 1]; });
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  std::vector<const std::uint32_t*> by_pixel(begin_.back());
  std::vector<std::uint32_t> next = begin_;
  for_each_row([&](std::size_t pixel, const std::uint32_t* row) { by_pixel[next[pixel]++] = row; });
  table_.reserve(by_pixel.size());
  std::size_t first = 0;
  for (std::size_t pixel = 0; pixel + 1 < begin_.size(); ++pixel) {
    const std::size_t end = begin_[pixel + 1];
    add_sorted(std::span(by_pixel).subspan(first, end - first));
    first = end;
    begin_[pixel + 1] = static_cast<std::uint32_t>(table_.rows());
  }
}

void PointTable::add_sorted(std::span<const std::uint32_t*> rows) {
  std::sort(rows.begin(), rows.end(),
            [](const std::uint32_t* a, const std::uint32_t* b) { return comes_before(point_of(a), point_of(b)); });
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (k == 0 || point_of(rows[k - 1]) != point_of(rows[k])) std::copy_n(rows[k], table_.columns(), table_.add_row());
  }
}

std::size_t PointTable::pixel_of(GridPoint point) const {
  const std::uint32_t row = (point.row >> log2_steps_) - first_.row;  // above all rows where it is less
  const std::uint32_t column = (point.column >> log2_steps_) - first_.column;
  if (row >= rows_ || column >= columns_) return begin_.size() - 1;
  return std::size_t{row} * columns_ + column;
}

const std::uint32_t* PointTable::find(GridPoint point) const {
  const std::size_t pixel = pixel_of(point);
  if (pixel + 1 == begin_.size()) return nullptr;
  std::size_t first = begin_[pixel];
  std::size_t count = begin_[pixel + 1] - first;
  if (count == 0) return nullptr;
  while (count > 1) {  // the last that does not come after the point, which a corner is at once
    const std::size_t half = count / 2;
    if (comes_before(point, point_of(table_.row(first + half)))) {
      count = half;
    } else {
      first += half;
      count -= half;
    }
  }
  const std::uint32_t* row = table_.row(first);
  return point_of(row) == point ? row : nullptr;
}

}  // namespace pyrasim::hw
