// SPDX-License-Identifier: Apache-2.0
#include "text/counted.h"

#include <gtest/gtest.h>

namespace pyrasim {
namespace {

TEST(Counted, OneIsNotSeveral) {
  EXPECT_EQ(counted(0, "ray"), "0 rays");
  EXPECT_EQ(counted(1, "ray"), "1 ray");
  EXPECT_EQ(counted(2, "ray"), "2 rays");
  EXPECT_EQ(of_number(1, "is", "are"), "is");
  EXPECT_EQ(of_number(0, "is", "are"), "are");
  EXPECT_EQ(of_number(11, "is", "are"), "are");
}

}  // namespace
}  // namespace pyrasim
