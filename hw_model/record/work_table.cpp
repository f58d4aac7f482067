// SPDX-License-Identifier: Apache-2.0
#include "hw_model/record/work_table.h"

#include "hw_model/record/varint.h"

namespace pyrasim::hw {

std::string WorkTable::packed() const {
  std::string bytes;
  bytes.reserve(values_.size() + values_.size() / 4);
  append_varint(bytes, rows());
  for (std::size_t column = 0; column < columns_; ++column) {
    std::int64_t above = 0;
    for (std::size_t k = column; k < values_.size(); k += columns_) {
      const std::int64_t value = values_[k];
      append_varint(bytes, zigzag(value - above));
      above = value;
    }
  }
  return bytes;
}

bool WorkTable::add_packed(std::string_view bytes) {
  const std::size_t before = values_.size();
  const auto refuse = [&] {
    values_.resize(before);
    return false;
  };
  const auto added = take_varint(bytes);
  if (!added || *added > bytes.size() / columns_) return refuse();  // a number takes a byte at least
  values_.resize(before + *added * columns_);
  for (std::size_t column = 0; column < columns_; ++column) {
    std::int64_t value = 0;
    for (std::size_t k = before + column; k < values_.size(); k += columns_) {
      const auto difference = take_varint(bytes);
      if (!difference || *difference > zigzag(UINT32_MAX)) return refuse();
      value += from_zigzag(*difference);
      if (value < 0 || value > UINT32_MAX) return refuse();
      values_[k] = static_cast<std::uint32_t>(value);
    }
  }
  return bytes.empty() || refuse();
}

}  // namespace pyrasim::hw
