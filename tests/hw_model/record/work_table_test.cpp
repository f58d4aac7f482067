// SPDX-License-Identifier: Apache-2.0
#include "hw_model/record/work_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

#include "hw_model/record/varint.h"

namespace pyrasim::hw {
namespace {

TEST(Varint, HasAsManyBytesAsItsNumberNeeds) {
  for (const auto& [number, bytes] : {std::pair<std::uint64_t, std::string>{0, std::string(1, '\0')},
                                      {127, "\x7F"},
                                      {128, "\x80\x01"},
                                      {300, "\xAC\x02"},
                                      {~std::uint64_t{0}, std::string(9, '\xFF') + '\x01'}}) {
    std::string written;
    append_varint(written, number);
    EXPECT_EQ(written, bytes);
    std::string_view rest = written;
    EXPECT_EQ(take_varint(rest), number);
    EXPECT_TRUE(rest.empty());
  }
}

TEST(Varint, ThatIsCutOrTooLargeIsNone) {
  for (const std::string& bytes : {std::string(), std::string("\x80"), std::string(10, '\xFF'),
                                   std::string(9, '\xFF') + '\x02', std::string(10, '\x80') + '\x01'}) {
    std::string_view rest = bytes;
    EXPECT_EQ(take_varint(rest), std::nullopt);
  }
}

TEST(Zigzag, CountsOutwards) {
  for (const auto& [number, code] : {std::pair<std::int64_t, std::uint64_t>{0, 0},
                                     {-1, 1},
                                     {1, 2},
                                     {-2, 3},
                                     {2, 4},
                                     {0xFFFFFFFFLL, 0x1FFFFFFFEULL}}) {
    EXPECT_EQ(zigzag(number), code);
    EXPECT_EQ(from_zigzag(code), number);
  }
}

WorkTable random_table(std::mt19937_64& random, std::size_t columns, std::size_t rows) {
  WorkTable table(columns);
  for (std::size_t k = 0; k < rows; ++k) {
    std::uint32_t* row = table.add_row();
    for (std::size_t column = 0; column < columns; ++column) {
      row[column] = static_cast<std::uint32_t>(random() >> 32U >> random() % 33);
    }
  }
  return table;
}

void expect_equal(const WorkTable& a, const WorkTable& b) {
  ASSERT_EQ(a.rows(), b.rows());
  for (std::size_t k = 0; k < a.rows(); ++k) EXPECT_TRUE(std::equal(a.row(k), a.row(k) + a.columns(), b.row(k)));
}

TEST(WorkTable, IsWhatWasPacked) {
  std::mt19937_64 random(1);
  for (const std::size_t rows : {0, 1, 2, 100}) {
    const WorkTable table = random_table(random, 5, rows);
    WorkTable read(5);
    ASSERT_TRUE(read.add_packed(table.packed()));
    expect_equal(read, table);
  }
}

TEST(WorkTable, OneAfterTheOther) {
  std::mt19937_64 random(2);
  const WorkTable first = random_table(random, 3, 7);
  const WorkTable second = random_table(random, 3, 4);
  WorkTable read(3);
  ASSERT_TRUE(read.add_packed(first.packed()));
  ASSERT_TRUE(read.add_packed(second.packed()));
  ASSERT_EQ(read.rows(), 11U);
  EXPECT_TRUE(std::equal(second.row(0), second.row(0) + 3, read.row(7)));
}

TEST(WorkTable, RefusesWhatIsNoTable) {
  std::mt19937_64 random(3);
  const WorkTable table = random_table(random, 4, 9);
  const std::string whole = table.packed();
  WorkTable read = table;
  for (std::size_t size = 0; size < whole.size(); ++size) EXPECT_FALSE(read.add_packed(whole.substr(0, size)));
  EXPECT_FALSE(read.add_packed(whole + '\0'));
  std::string below;
  append_varint(below, 1);
  append_varint(below, zigzag(-1));
  WorkTable one(1);
  EXPECT_FALSE(one.add_packed(below));
  std::string above;
  append_varint(above, 2);
  append_varint(above, zigzag(std::numeric_limits<std::uint32_t>::max()));
  append_varint(above, zigzag(1));
  EXPECT_FALSE(one.add_packed(above));
  std::string many;
  append_varint(many, std::uint64_t{1} << 62U);
  EXPECT_FALSE(one.add_packed(many));
  EXPECT_EQ(one.rows(), 0U);
  expect_equal(read, table);
}

}  // namespace
}  // namespace pyrasim::hw
