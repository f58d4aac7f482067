// SPDX-License-Identifier: Apache-2.0
#include "text/display_width.h"

#include <gtest/gtest.h>

namespace pyrasim {
namespace {

TEST(DisplayWidth, CountsColumns) {
  EXPECT_EQ(display_width(""), 0U);
  EXPECT_EQ(display_width("units"), 5U);
  EXPECT_EQ(display_width("units=\u00D72"), 8U);
  EXPECT_EQ(display_width("Szen\u00E9\u2026"), 6U);
  EXPECT_EQ(display_width("\u6F22\u5B57"), 4U);
}

TEST(DisplayWidth, IsWhatPaddingFillsUp) {
  for (const std::string_view text : {"", "units", "units=\u00D72", "\u6F22\u5B57", "\U0001F600 smile"}) {
    const std::size_t width = display_width(text);
    EXPECT_EQ(fmt::format("{:<{}}", text, width), text);
    EXPECT_EQ(fmt::format("{:<{}}", text, width + 1), std::string(text) + ' ');
  }
}

}  // namespace
}  // namespace pyrasim
