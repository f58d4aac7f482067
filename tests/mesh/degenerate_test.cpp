// SPDX-License-Identifier: Apache-2.0
#include "mesh/degenerate.h"

#include <gtest/gtest.h>

#include <random>

namespace pyrasim {
namespace {

using glm::dvec3;

TEST(Degenerate, RepeatedAndCollinearPoints) {
  EXPECT_TRUE(is_degenerate({0, 0, 0}, {0, 0, 0}, {0, 0, 0}));
  EXPECT_TRUE(is_degenerate({1, 2, 3}, {1, 2, 3}, {4, 5, 7}));
  EXPECT_TRUE(is_degenerate({1, 2, 3}, {4, 5, 7}, {1, 2, 3}));
  EXPECT_TRUE(is_degenerate({4, 5, 7}, {1, 2, 3}, {1, 2, 3}));
  EXPECT_TRUE(is_degenerate({0, 0, 0}, {1, 2, 3}, {3, 6, 9}));
}

TEST(Degenerate, CollinearAfterRounding) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int i = 0; i < 1000; ++i) {
    const dvec3 origin(number(random), number(random), number(random));
    const dvec3 along(number(random), number(random), number(random));
    EXPECT_TRUE(is_degenerate(origin, origin + along, origin + number(random) * along));
  }
}

TEST(Degenerate, AnswerDoesNotDependOnScale) {
  for (const double scale : {1e-300, 1e-30, 1e-7, 1.0, 1e30, 1e300}) {
    EXPECT_FALSE(is_degenerate(scale * dvec3(1, 0, 0), scale * dvec3(0, 1, 0), scale * dvec3(0, 0, 1))) << scale;
    EXPECT_FALSE(is_degenerate(scale * dvec3(0, 0, 0), scale * dvec3(1, 0, 0), scale * dvec3(1, 1e-9, 0))) << scale;
    EXPECT_TRUE(is_degenerate(scale * dvec3(1, 0, 1), scale * dvec3(2, 1, 2), scale * dvec3(3, 2, 3))) << scale;
  }
}

}  // namespace
}  // namespace pyrasim
