// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pyrasim::hw {

/// Rows of as many whole numbers each.
class WorkTable {
 public:
  explicit WorkTable(std::size_t columns) : columns_(columns) {}

  std::size_t columns() const { return columns_; }
  std::size_t rows() const { return values_.size() / columns_; }
  std::size_t numbers() const { return values_.size(); }
  const std::uint32_t* row(std::size_t number) const { return values_.data() + number * columns_; }
  void reserve(std::size_t rows) { values_.reserve(rows * columns_); }
  /// A further row, zeros.
  std::uint32_t* add_row() {
    values_.resize(values_.size() + columns_);
    return values_.data() + values_.size() - columns_;
  }
  void clear() { values_.clear(); }

  /// As bytes: the number of rows, then column by column each number's difference to the one above (of the first, to
  /// 0), all as varints, the differences by zigzag.
  std::string packed() const;
  /// Adds the rows that packed() made `bytes` of; whether it did. If not, nothing has changed.
  bool add_packed(std::string_view bytes);

 private:
  std::size_t columns_;
  std::vector<std::uint32_t> values_;
};

}  // namespace pyrasim::hw
