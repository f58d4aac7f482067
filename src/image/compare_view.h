// SPDX-License-Identifier: Apache-2.0
// Two pictures of the same scene beside each other, enlarged where they differ.
#pragma once

#include "image/image.h"

namespace pyrasim {

/// A rectangle of pixels whose top left one stands at `row` and `column`.
struct Crop {
  int row = 0;
  int column = 0;
  int rows = 0;
  int columns = 0;
};

/// Width in pixels of the white line between the two halves of side_by_side().
constexpr int separator_columns = 2;

/// The same crop of both pictures, each pixel repeated `scale` times in both directions, a white line between them.
/// Throws UsageError where the sizes of the pictures differ, the crop is empty or leaves them, or `scale` is below 1.
Image side_by_side(const Image& left, const Image& right, int row, int column, int rows, int columns, int scale);

/// The crop of at most `rows` by `columns` over which the sum of squared differences is greatest; of several such, the
/// topmost, then leftmost. A pixel whose difference is not finite counts as 1. It is no larger than the pictures.
/// Throws UsageError where the sizes of the pictures differ, or are 0, or `rows` or `columns` is below 1.
Crop busiest_crop(const Image& a, const Image& b, int rows, int columns);

}  // namespace pyrasim
