// SPDX-License-Identifier: Apache-2.0
#include "text/printable.h"

#include <gtest/gtest.h>

#include <string>

namespace pyrasim {
namespace {

using namespace std::string_literals;

TEST(Printable, LeavesTextsOfAllLanguagesAlone) {
  const std::string text = "plain ~ \\u000a \u00e9 \u03b1\u03b2 \u4e2d\u6587 \U0001f600 \u00a0";
  EXPECT_EQ(one_line(text), text);
  EXPECT_EQ(one_line(""), "");
}

TEST(Printable, WritesOutWhatSteersATerminal) {
  EXPECT_EQ(one_line("a\nb\r\tc\0d"s), "a\\u000ab\\u000d\\u0009c\\u0000d");
  EXPECT_EQ(one_line("\x1b[31m\x7f"), "\\u001b[31m\\u007f");
  EXPECT_EQ(one_line("\u0080\u009b2J\u009f"), "\\u0080\\u009b2J\\u009f");
  EXPECT_EQ(one_line("\u2028\u2029\u200e\u200f\u061c"), "\\u2028\\u2029\\u200e\\u200f\\u061c");
  EXPECT_EQ(one_line("\u202aa\u202eb\u2066c\u2069"), "\\u202aa\\u202eb\\u2066c\\u2069");
}

TEST(Printable, WritesOutBytesThatAreNoUtf8) {
  EXPECT_EQ(one_line("sc\xe8ne"), "sc\\xe8ne");
  EXPECT_EQ(one_line("\x9b"
                     "31m"),
            "\\x9b31m");                                            // a C1 control of eight bits
  EXPECT_EQ(one_line("\xc0\x9b"), "\\xc0\\x9b");                    // an overlong escape
  EXPECT_EQ(one_line("\xe0\x82\x9b"), "\\xe0\\x82\\x9b");           // another
  EXPECT_EQ(one_line("\xed\xa0\x80"), "\\xed\\xa0\\x80");           // a surrogate
  EXPECT_EQ(one_line("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80");  // beyond U+10FFFF
  EXPECT_EQ(one_line("\xe4\xb8"), "\\xe4\\xb8");                    // cut off
}

TEST(Printable, NothingThatSteersIsLeftOfAnyCharacterOrByte) {
  std::string all;
  for (int byte = 0; byte < 256; ++byte) all += static_cast<char>(byte);
  for (int byte = 0x80; byte < 0xa0; ++byte) all += {'\xc2', static_cast<char>(byte)};
  const std::string shown = one_line(all);
  EXPECT_EQ(first_not_utf8(shown), shown.size());
  for (const char c : shown) EXPECT_GE(static_cast<unsigned char>(c), 0x20);
  EXPECT_EQ(shown.find('\x7f'), std::string::npos);
  EXPECT_EQ(shown.find("\u0080"), std::string::npos);
  EXPECT_EQ(one_line(shown), shown);
}

TEST(Printable, ExcerptsAreCutBetweenCharacters) {
  EXPECT_EQ(excerpt("abcd", 4), "abcd");
  EXPECT_EQ(excerpt("abcde", 4), "abcd\u2026");
  EXPECT_EQ(excerpt("\u00e9\u00e9\u00e9", 2), "\u00e9\u00e9\u2026");
  EXPECT_EQ(excerpt("a\nb", 7), "a\\u000a\u2026");  // counted as it is shown
  EXPECT_EQ(excerpt("a\nb", 6), "a\u2026");
  EXPECT_EQ(excerpt(std::string(3'000'000, 'w')), std::string(60, 'w').append("\u2026"));
}

TEST(Printable, ValuesMayBeEmpty) {
  EXPECT_EQ(value_excerpt(""), "(empty)");
  EXPECT_EQ(value_excerpt("64x\n"), "64x\\u000a");
}

TEST(Printable, MessagesKeepTheirEnds) {
  EXPECT_EQ(message_line("short\n"), "short\\u000a");
  const std::string message = "begin" + std::string(3'000'000, 'w') + "\u00e9" + std::string(299, 'x') + "end";
  const std::string shown = message_line(message);
  EXPECT_LT(shown.size(), 1200U);
  EXPECT_EQ(shown.find("begin"), 0U);
  EXPECT_EQ(shown.substr(shown.size() - 3), "end");
  std::string accents;
  for (int k = 0; k < 5000; ++k) accents += "\u00e9";
  EXPECT_EQ(message_line(accents).find("\\x"), std::string::npos);
  EXPECT_EQ(message_line("a" + accents).find("\\x"), std::string::npos);
}

TEST(Printable, FindsTheFirstByteThatIsNoUtf8) {
  EXPECT_EQ(first_not_utf8(""), 0U);
  EXPECT_EQ(first_not_utf8("\u00e9\u4e2d\U0010ffff"), 9U);
  EXPECT_EQ(first_not_utf8("\u00e9\xff"), 2U);
  EXPECT_EQ(first_not_utf8("ab\xc3"), 2U);
}

}  // namespace
}  // namespace pyrasim
