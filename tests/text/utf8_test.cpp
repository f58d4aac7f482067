// SPDX-License-Identifier: Apache-2.0
#include "text/utf8.h"

#include <gtest/gtest.h>

namespace pyrasim {
namespace {

TEST(Utf8, code_points_of_every_length) {
  const std::string text = "a\u00E4\u20AC\U0001F600";
  std::size_t position = 0;
  for (const char32_t expected : {U'a', U'\u00E4', U'\u20AC', U'\U0001F600'}) {
    EXPECT_EQ(next_code_point(text, position), expected);
  }
  EXPECT_EQ(position, text.size());
}

/// RFC 3629, 3 and 4: the first and last of each length, and what lies beyond them.
TEST(Utf8, limits) {
  for (const char* good : {"\x7F", "\xC2\x80", "\xDF\xBF", "\xE0\xA0\x80", "\xED\x9F\xBF", "\xEE\x80\x80",
                           "\xEF\xBF\xBF", "\xF0\x90\x80\x80", "\xF4\x8F\xBF\xBF"}) {
    EXPECT_EQ(valid_utf8(good), good);
  }
  for (const char* bad :
       {"\x80", "\xBF", "\xC0\x80", "\xC1\xBF", "\xE0\x9F\xBF", "\xED\xA0\x80", "\xED\xBF\xBF", "\xF0\x8F\xBF\xBF",
        "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xFE", "\xFF", "\xC3", "\xE2\x82", "\xF0\x9F\x98"}) {
    const std::string text = valid_utf8(bad);
    EXPECT_NE(text, bad);
    EXPECT_EQ(valid_utf8(text), text);
  }
}

TEST(Utf8, what_is_not_is_replaced_and_the_rest_stays) {
  EXPECT_EQ(valid_utf8("sph\xE8re"), "sph\uFFFDre");
  EXPECT_EQ(valid_utf8("cut \xE2\x82"), "cut \uFFFD");
  EXPECT_EQ(valid_utf8("\xC3("), "\uFFFD(");
  EXPECT_EQ(valid_utf8(std::string("a\0b", 3)), std::string("a\0b", 3));
}

}  // namespace
}  // namespace pyrasim
