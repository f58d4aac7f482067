// SPDX-License-Identifier: Apache-2.0
#include "image/compare_view.h"

#include <cmath>
#include <random>

#include "../temporary_folder.h"
#include "error.h"

namespace pyrasim {
namespace {

/// The sum over a crop without a table.
double slow_sum(const Image& a, const Image& b, const Crop& crop) {
  double sum = 0;
  for (int row = crop.row; row < crop.row + crop.rows; ++row) {
    for (int column = crop.column; column < crop.column + crop.columns; ++column) {
      const glm::vec3 difference = a.at(row, column) - b.at(row, column);
      for (int channel = 0; channel < 3; ++channel)
        sum += static_cast<double>(difference[channel]) * difference[channel];
    }
  }
  return sum;
}

TEST(BusiestCrop, finds_the_spot) {
  Image a(20, 10);
  const Image b(20, 10);
  a.at(7, 13) = glm::vec3(1);
  a.at(6, 12) = glm::vec3(0.5F);
  a.at(1, 1) = glm::vec3(1);
  const Crop crop = busiest_crop(a, b, 2, 2);
  EXPECT_EQ(crop.row, 6);
  EXPECT_EQ(crop.column, 12);
  EXPECT_EQ(crop.rows, 2);
  EXPECT_EQ(crop.columns, 2);
}

TEST(BusiestCrop, no_other_crop_has_a_greater_sum) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 20; ++trial) {
    Image a(9, 7);
    Image b(9, 7);
    // Sixteenths, so that every sum is exact.
    for (glm::vec3& pixel : a.pixels()) pixel = glm::vec3(random() % 17, random() % 17, random() % 17) / 16.0F;
    for (glm::vec3& pixel : b.pixels()) pixel = glm::vec3(random() % 17, random() % 17, random() % 17) / 16.0F;
    const Crop busiest = busiest_crop(a, b, 3, 4);
    for (int row = 0; row <= 4; ++row) {
      for (int column = 0; column <= 5; ++column) {
        EXPECT_LE(slow_sum(a, b, {row, column, 3, 4}), slow_sum(a, b, busiest));
      }
    }
  }
}

TEST(BusiestCrop, of_equal_or_small_pictures) {
  const Crop equal = busiest_crop(Image(5, 4), Image(5, 4), 2, 2);
  EXPECT_EQ(equal.row, 0);
  EXPECT_EQ(equal.column, 0);
  const Crop whole = busiest_crop(Image(5, 4), Image(5, 4), 100, 100);
  EXPECT_EQ(whole.rows, 4);
  EXPECT_EQ(whole.columns, 5);
}

TEST(BusiestCrop, not_a_number_is_a_difference) {
  Image a(4, 1);
  a.at(0, 2) = glm::vec3(std::nanf(""));
  EXPECT_EQ(busiest_crop(a, Image(4, 1), 1, 1).column, 2);
}

TEST(BusiestCrop, unusable_requests) {
  EXPECT_THROW(busiest_crop(Image(2, 2), Image(2, 3), 1, 1), UsageError);
  EXPECT_THROW(busiest_crop(Image(2, 2), Image(2, 2), 0, 1), UsageError);
  EXPECT_THROW(busiest_crop(Image(), Image(), 1, 1), UsageError);
}

TEST(SideBySide, repeats_pixels_on_both_sides_of_a_white_line) {
  const Image left = grey_row({0.0F, 0.1F, 0.2F});
  const Image right = grey_row({0.5F, 0.6F, 0.7F});
  const Image view = side_by_side(left, right, 0, 1, 1, 2, 2);
  const std::vector<float> row = {0.1F, 0.1F, 0.2F, 0.2F, 1.0F, 1.0F, 0.6F, 0.6F, 0.7F, 0.7F};
  ASSERT_EQ(view.columns(), 10);
  ASSERT_EQ(view.rows(), 2);
  for (int column = 0; column < 10; ++column) {
    const auto index = static_cast<std::size_t>(column);
    EXPECT_EQ(view.at(0, column), glm::vec3(row[index])) << column;
    EXPECT_EQ(view.at(1, column), glm::vec3(row[index])) << column;
  }
}

TEST(SideBySide, takes_rows_from_the_crop) {
  Image left(1, 4);
  for (int row = 0; row < 4; ++row) left.at(row, 0) = glm::vec3(static_cast<float>(row));
  const Image view = side_by_side(left, left, 2, 0, 2, 1, 1);
  EXPECT_EQ(view.at(0, 0), glm::vec3(2));
  EXPECT_EQ(view.at(1, 0), glm::vec3(3));
}

TEST(SideBySide, unusable_requests) {
  const Image image(4, 3);
  EXPECT_THROW(side_by_side(image, Image(3, 4), 0, 0, 1, 1, 1), UsageError);
  EXPECT_EQ(message_of<UsageError>([&] { side_by_side(image, image, 1, 2, 2, 3, 1); }),
            "crop 3x2 at row 1, column 2; it must lie inside the pictures, which are 4x3");
  EXPECT_THROW(side_by_side(image, image, -1, 0, 1, 1, 1), UsageError);
  EXPECT_THROW(side_by_side(image, image, 0, 0, 0, 1, 1), UsageError);
  EXPECT_THROW(side_by_side(image, image, 0, 0, 1, 1, 0), UsageError);
  EXPECT_THROW(side_by_side(image, image, 0, 0, 1, 1, 2000000000), UsageError);
  EXPECT_NO_THROW(side_by_side(image, image, 1, 2, 2, 2, 1));
}

}  // namespace
}  // namespace pyrasim
