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

TEST(PictureMemory, AnyMachineHoldsASmallPicture) {
  EXPECT_GT(physical_memory(), 1ULL << 28U);
  check_picture_fits({0, 0, 640, 480});
}

}  // namespace
}  // namespace pyrasim
