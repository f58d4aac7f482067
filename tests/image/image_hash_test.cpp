// SPDX-License-Identifier: Apache-2.0
#include "image/image_hash.h"

#include <gtest/gtest.h>

namespace pyrasim {
namespace {

TEST(ImageHash, is_that_of_the_bytes_from_the_top) {
  Image image(1, 2);
  image.at(0, 0) = {0.0F, 0.5F, 1.0F};
  image.at(1, 0) = {0.25F, 2.0F, -1.5F};
  // printf '\0\0\0\0\0\0\0\x3f\0\0\x80\x3f\0\0\x80\x3e\0\0\0\x40\0\0\xc0\xbf' | sha256sum
  EXPECT_EQ(image_sha256(image), "6bca0a9061b3a678a155acd628f72d8a58e2ee7d347cffb220df1bc2335516df");
}

TEST(ImageHash, of_nothing) {
  EXPECT_EQ(image_sha256(Image()), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

}  // namespace
}  // namespace pyrasim
