// SPDX-License-Identifier: Apache-2.0
#include "image/compare_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "error.h"
#include "image/image_error.h"
#include "image/read_bytes.h"

namespace pyrasim {
namespace {

double squared_difference(const glm::vec3& a, const glm::vec3& b) {
  double sum = 0;
  for (int channel = 0; channel < 3; ++channel) {
    const double distance = static_cast<double>(a[channel]) - static_cast<double>(b[channel]);
    sum += distance * distance;
  }
  return std::isfinite(sum) ? sum : 1.0;
}

/// sum(row, column): all squared differences above `row` and left of `column`.
class SummedDifferences {
 public:
  SummedDifferences(const Image& a, const Image& b)
      : stride_(static_cast<std::size_t>(a.columns()) + 1), sums_(stride_ * (static_cast<std::size_t>(a.rows()) + 1)) {
    for (int row = 0; row < a.rows(); ++row) {
      double of_row = 0;
      for (int column = 0; column < a.columns(); ++column) {
        of_row += squared_difference(a.at(row, column), b.at(row, column));
        sums_[index(row + 1, column + 1)] = sums_[index(row, column + 1)] + of_row;
      }
    }
  }

  double over(const Crop& crop) const {
    const int bottom = crop.row + crop.rows;
    const int right = crop.column + crop.columns;
    return (sums_[index(bottom, right)] - sums_[index(crop.row, right)]) -
           (sums_[index(bottom, crop.column)] - sums_[index(crop.row, crop.column)]);
  }

 private:
  std::size_t index(int row, int column) const {
    return static_cast<std::size_t>(row) * stride_ + static_cast<std::size_t>(column);
  }

  std::size_t stride_;
  std::vector<double> sums_;
};

void check_crop(const Image& image, const Crop& crop) {
  const bool inside = crop.row >= 0 && crop.column >= 0 && crop.rows >= 1 && crop.columns >= 1 &&
                      crop.rows <= image.rows() - crop.row && crop.columns <= image.columns() - crop.column;
  if (inside) return;
  throw UsageError(fmt::format("crop {}x{} at row {}, column {}; it must lie inside the pictures, which are {}x{}",
                               crop.columns, crop.rows, crop.row, crop.column, image.columns(), image.rows()));
}

void check_scale(const Crop& crop, int scale) {
  const double pixels = (2.0 * crop.columns * scale + separator_columns) * crop.rows * scale;
  if (scale >= 1 && pixels <= static_cast<double>(max_pixels)) return;
  throw UsageError(
      fmt::format("scale {}; it must be at least 1 and give no more than {} pixels in all", scale, max_pixels));
}

}  // namespace

Image side_by_side(const Image& left, const Image& right, int row, int column, int rows, int columns, int scale) {
  check_same_size(left, right);
  check_crop(left, {row, column, rows, columns});
  check_scale({row, column, rows, columns}, scale);
  const int half = columns * scale;
  Image view(2 * half + separator_columns, rows * scale);
  std::fill(view.pixels().begin(), view.pixels().end(), glm::vec3(1.0F));
  for (int y = 0; y < view.rows(); ++y) {
    for (int x = 0; x < half; ++x) {
      view.at(y, x) = left.at(row + y / scale, column + x / scale);
      view.at(y, half + separator_columns + x) = right.at(row + y / scale, column + x / scale);
    }
  }
  return view;
}

Crop busiest_crop(const Image& a, const Image& b, int rows, int columns) {
  check_same_size(a, b);
  Crop crop{0, 0, std::min(rows, a.rows()), std::min(columns, a.columns())};
  check_crop(a, crop);
  const SummedDifferences differences(a, b);
  Crop busiest = crop;
  double greatest = differences.over(crop);
  for (crop.row = 0; crop.row <= a.rows() - crop.rows; ++crop.row) {
    for (crop.column = 0; crop.column <= a.columns() - crop.columns; ++crop.column) {
      const double sum = differences.over(crop);
      if (sum <= greatest) continue;
      greatest = sum;
      busiest = crop;
    }
  }
  return busiest;
}

}  // namespace pyrasim
