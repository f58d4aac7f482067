// SPDX-License-Identifier: Apache-2.0
#include "hw_model/record/point_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <utility>

namespace pyrasim::hw {
namespace {

constexpr PixelWindow window{5, 3, 6, 4};  // column, row, columns, rows

void add(WorkTable& table, std::uint32_t row, std::uint32_t column, std::uint32_t value) {
  std::uint32_t* numbers = table.add_row();
  numbers[0] = row;
  numbers[1] = column;
  numbers[2] = value;
}

TEST(PointTable, FindsEachPointAndNoOther) {
  for (const int max_level : {0, 1, 3}) {
    SCOPED_TRACE(max_level);
    const std::uint32_t steps = 1U << static_cast<unsigned>(max_level);
    std::mt19937_64 random(max_level);
    WorkTable rows(3);
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> known;
    for (std::uint32_t row = 3 * steps; row <= 7 * steps; ++row) {
      for (std::uint32_t column = 5 * steps; column <= 11 * steps; ++column) {
        if (random() % 3 != 0) known[{row, column}] = static_cast<std::uint32_t>(random());
      }
    }
    std::vector<std::pair<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t>> order(known.begin(), known.end());
    order.insert(order.end(), known.begin(), known.end());  // twice
    std::shuffle(order.begin(), order.end(), random);
    for (const auto& [point, value] : order) add(rows, point.first, point.second, value);
    const PointTable table(rows, window, max_level);
    for (std::uint32_t row = 0; row <= 9 * steps; ++row) {
      for (std::uint32_t column = 0; column <= 13 * steps; ++column) {
        const auto place = known.find({row, column});
        const std::uint32_t* found = table.find({row, column});
        ASSERT_EQ(found != nullptr, place != known.end()) << row << ", " << column;
        if (found != nullptr) {
          EXPECT_EQ(found[2], place->second);
        }
      }
    }
  }
}

TEST(PointTable, LeavesOutWhatIsOutside) {
  WorkTable rows(3);
  add(rows, 0, 0, 1);
  add(rows, 0xFFFFFFFFU, 0xFFFFFFFFU, 1);
  add(rows, 8, 5, 1);
  add(rows, 3, 12, 1);
  const PointTable table(rows, window, 0);
  for (std::size_t k = 0; k < rows.rows(); ++k) EXPECT_EQ(table.find({rows.row(k)[0], rows.row(k)[1]}), nullptr);
}

}  // namespace
}  // namespace pyrasim::hw
