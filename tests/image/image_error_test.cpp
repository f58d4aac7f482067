// SPDX-License-Identifier: Apache-2.0
#include "image/image_error.h"

#include <cmath>
#include <limits>

#include "../temporary_folder.h"
#include "error.h"

namespace pyrasim {
namespace {

TEST(ImageError, of_equal_pictures_is_zero) {
  const Image image = grey_row({0.25F, std::numeric_limits<float>::infinity()});
  const ImageError error = image_error(image, image);
  EXPECT_EQ(error.rmse, 0);
  EXPECT_EQ(error.maximum, 0);
  EXPECT_EQ(psnr(image, image), std::numeric_limits<double>::infinity());
}

TEST(ImageError, by_hand) {
  Image image(2, 1);
  image.at(0, 0) = {0.5F, 0.0F, 1.0F};
  image.at(0, 1) = {0.0F, 0.25F, 0.0F};
  Image reference(2, 1);
  reference.at(0, 0) = {0.0F, 0.0F, 1.0F};
  reference.at(0, 1) = {0.0F, 1.0F, 0.0F};
  const ImageError error = image_error(image, reference);
  EXPECT_DOUBLE_EQ(error.rmse, std::sqrt((0.25 + 0.5625) / 6));
  EXPECT_DOUBLE_EQ(error.maximum, 0.75);
}

TEST(ImageError, psnr_of_a_tenth_is_twenty) { EXPECT_NEAR(psnr(grey_row({0.1F}), grey_row({0.0F})), 20.0, 1e-6); }

TEST(ImageError, not_a_number_is_infinitely_far_off) {
  const ImageError error = image_error(grey_row({std::nanf(""), 0.0F}), grey_row({0.0F, 0.0F}));
  EXPECT_EQ(error.rmse, std::numeric_limits<double>::infinity());
  EXPECT_EQ(error.maximum, std::numeric_limits<double>::infinity());
}

TEST(ImageError, sizes_must_match) {
  EXPECT_EQ(message_of<UsageError>([] { image_error(Image(2, 1), Image(1, 2)); }),
            "2x1 and 1x2: pictures can be compared only where their sizes are the same");
  EXPECT_THROW(psnr(Image(2, 1), Image(1, 2)), UsageError);
}

}  // namespace
}  // namespace pyrasim
