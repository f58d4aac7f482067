// SPDX-License-Identifier: Apache-2.0
#include "camera/camera.h"

#include <gtest/gtest.h>

namespace pyrasim {
namespace {

TEST(Resized, KeepsWidthDistanceAndAspect) {
  const Screen half = resized({640, 480, 1.5, 0.002, 0.003}, 320, 240);
  EXPECT_EQ(half.columns, 320);
  EXPECT_EQ(half.rows, 240);
  EXPECT_DOUBLE_EQ(half.columns * half.dz, 640 * 0.003);
  EXPECT_EQ(half.dx, 1.5);
  EXPECT_DOUBLE_EQ(half.dy / half.dz, 0.002 / 0.003);
}

TEST(Resized, RowsDoNotChangeThePixel) {
  const Screen wide = resized({640, 480, 1, 0.002, 0.003}, 1000, 3);
  EXPECT_EQ(wide.rows, 3);
  EXPECT_DOUBLE_EQ(wide.dz, 0.003 * 0.64);
  EXPECT_DOUBLE_EQ(wide.dy, 0.002 * 0.64);
}

TEST(Resized, ToTheSameSizeChangesNothing) {
  const Screen same = resized({641, 480, 1.1, 0.0021, 0.0033}, 641, 480);
  EXPECT_EQ(same.dx, 1.1);
  EXPECT_EQ(same.dy, 0.0021);
  EXPECT_EQ(same.dz, 0.0033);
}

}  // namespace
}  // namespace pyrasim
