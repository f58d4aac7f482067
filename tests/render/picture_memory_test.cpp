// SPDX-License-Identifier: Apache-2.0
#include "render/picture_memory.h"

#include <gtest/gtest.h>

#include "../error_of.h"
#include "error.h"

namespace pyrasim {
namespace {

TEST(PictureMemory, ToTheByte) {
  const PixelWindow window{0, 0, 4096, 4096};
  constexpr std::uint64_t needed = 2ULL * 4096 * 4096 * 12;
  check_picture_fits(window, needed);
  EXPECT_EQ(error_of<LimitError>([&] { check_picture_fits(window, needed - 1); }),
            "a picture of 4096x4096 pixels takes 0.4 GiB of memory, and this machine has 0.4 GiB; render and simulate "
            "make a part of the picture with --window X,Y,COLUMNS,ROWS");
}

TEST(PictureMemory, OfTheLargestScreenDoesNotOverflow) {
  const PixelWindow window{0, 0, max_screen_size, max_screen_size};
  EXPECT_NE(error_of<LimitError>([&] { check_picture_fits(window, 1ULL << 36U); }).find("takes 96.0 GiB"),
            std::string::npos);
  check_picture_fits(window, 1ULL << 37U);
}

TEST(PictureMemory, OfPicturesAtTheSameTime) {
  const PixelWindow large{0, 0, 1000, 100};
  const PixelWindow small{0, 0, 100, 100};
  constexpr std::uint64_t pixel = 12;
  // The two largest pictures, and the two largest references.
  constexpr std::uint64_t needed = (100'000 + 100'000 + 100'000 + 10'000) * pixel;
  const std::vector<PixelWindow> pictures{small, large, small, large, small};
  check_pictures_fit(pictures, {small, large, small}, 2, needed);
  EXPECT_EQ(error_of<LimitError>([&] {
              check_pictures_fit(pictures, {small, large, small}, 2, needed - 1);
            }),
            "2 pictures at the same time take 0.0 GiB of memory with their references, and this machine has 0.0 GiB; a "
            "smaller --jobs takes less memory");
  check_pictures_fit(pictures, {large}, 1, 200'000 * pixel);
  EXPECT_NE(error_of<LimitError>([&] {
              check_pictures_fit(pictures, {}, 1, 200'000 * pixel - 1);
            }).find("a picture of 1000x100 pixels"),
            std::string::npos);
  check_pictures_fit(pictures, {large}, 1000, (230'000 + 100'000) * pixel);  // no more than there are
}

TEST(PictureMemory, AnyMachineHoldsASmallPicture) {
  EXPECT_GT(physical_memory(), 1ULL << 28U);
  check_picture_fits({0, 0, 640, 480});
}

}  // namespace
}  // namespace pyrasim
