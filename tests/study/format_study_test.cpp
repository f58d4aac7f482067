// SPDX-License-Identifier: Apache-2.0
#include "study/format_study.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "study/format_plot.h"

namespace pyrasim {
namespace {

FormatRow row(const char* format, std::uint64_t changed) {
  FormatRow result;
  result.format = parse_number_format(format);
  result.changed_pixels = changed;
  result.psnr = changed == 0 ? std::numeric_limits<double>::infinity() : 61.25;
  result.flips.flipped = 7 * changed;
  return result;
}

std::vector<FormatRow> rows() {
  std::vector<FormatRow> all{row("double", 0),   row("float", 0),    row("e8p20", 0),
                             row("fp24", 12),    row("bf16", 345),   row("fix64.32", 0),
                             row("fix48.24", 0), row("fix48.20", 2), row("fix32.20", 3)};
  all.push_back(row("fix24.12", 0));
  all.back().refused = "cannot address the screen";
  return all;
}

TEST(FormatStudy, SmallestFormatIsTheNarrowestUsableOneOfItsKind) {
  EXPECT_EQ(smallest_unchanged(rows(), false), parse_number_format("e8p20"));
  EXPECT_EQ(smallest_unchanged(rows(), true), parse_number_format("fix48.24"));
  EXPECT_EQ(smallest_unchanged({row("fix64.32", 0), row("fix64.28", 0), row("fix64.24", 1)}, true),
            parse_number_format("fix64.28"));
  EXPECT_EQ(smallest_unchanged({row("fp24", 1), row("fix32.20", 0)}, false), std::nullopt);
}

std::string table_of(const std::vector<FormatRow>& rows) {
  std::string text = format_table_header();
  for (const FormatRow& row : rows) text += format_table_row(row);
  return text + format_verdict(rows);
}

std::string csv_of(const std::vector<FormatRow>& rows) {
  std::string text = format_csv_header();
  for (const FormatRow& row : rows) text += format_csv_row(row);
  return text;
}

TEST(FormatStudy, TableHasALineForEachFormatAndTheSmallest) {
  const std::string table = table_of(rows());
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 1 + 10 + 3);
  EXPECT_NE(table.find("     fp24   24  e7 p17        12        84"), std::string::npos) << table;
  EXPECT_NE(table.find(" fix24.12   24 i11 f12 cannot address the screen\n"), std::string::npos) << table;
  EXPECT_NE(table.find("\n  floating point: e8p20, 28 bits (e8 p20)\n  fixed point: fix48.24, 48 bits (i23 f24)\n"),
            std::string::npos)
      << table;
  EXPECT_NE(table_of({row("fp24", 1)}).find("floating point: none of these"), std::string::npos);
}

TEST(FormatStudy, EveryLineOfTheCsvHasAsManyFieldsAsTheHeader) {
  const std::string csv = csv_of(rows());
  std::size_t begin = 0;
  int lines = 0;
  for (std::size_t end = csv.find('\n'); end != std::string::npos; end = csv.find('\n', begin)) {
    EXPECT_EQ(std::count(csv.begin() + static_cast<long>(begin), csv.begin() + static_cast<long>(end), ','), 17);
    begin = end + 1;
    ++lines;
  }
  EXPECT_EQ(lines, 11);
}

TEST(FormatPlot, DrawsAPointForEachUsableFormatInRangeAndEscapesItsTitle) {
  const std::string svg = format_plot(rows(), "a<b & c");
  EXPECT_NE(svg.find("a&lt;b &amp; c"), std::string::npos);
  std::size_t circles = 0;
  for (std::size_t at = svg.find("<circle"); at != std::string::npos; at = svg.find("<circle", at + 1)) ++circles;
  EXPECT_EQ(circles, 2U * 8);  // changed pixels and flips; neither double, which is off the axis, nor the refused one
  EXPECT_NE(svg.find("<title>bf16: 2415</title>"), std::string::npos);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
}

}  // namespace
}  // namespace pyrasim
