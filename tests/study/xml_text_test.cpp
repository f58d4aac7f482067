// SPDX-License-Identifier: Apache-2.0
#include "study/xml_text.h"

#include <gtest/gtest.h>

namespace pyrasim {
namespace {

TEST(XmlText, markup_is_escaped) { EXPECT_EQ(xml_text("a<b>&\"c\""), "a&lt;b&gt;&amp;&quot;c&quot;"); }

TEST(XmlText, letters_stay) { EXPECT_EQ(xml_text("K\u00E4se \u20AC \U0001F600"), "K\u00E4se \u20AC \U0001F600"); }

TEST(XmlText, what_xml_has_no_character_for_is_replaced) {
  EXPECT_EQ(xml_text("\x1B[2J\x7F\n"), "\uFFFD[2J\uFFFD\uFFFD");
  EXPECT_EQ(xml_text("\u009B\uFFFE\uFFFF"), "\uFFFD\uFFFD\uFFFD");
  EXPECT_EQ(xml_text("\xFF"), "\uFFFD");
  EXPECT_EQ(xml_text(std::string(1, '\0')), "\uFFFD");
}

}  // namespace
}  // namespace pyrasim
