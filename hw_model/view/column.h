// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "hw_model/record/varint.h"

namespace pyrasim::hw {

/// Numbers of one kind, one after another, as bytes: each a varint, or of those that grow or repeat the difference to
/// the number before, of the first to 0.
class Column {
 public:
  void add(std::uint64_t number) { append_varint(bytes_, number); }
  void add_difference(std::uint64_t number) {
    append_varint(bytes_, zigzag(static_cast<std::int64_t>(number - last_)));
    last_ = number;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
  std::uint64_t last_ = 0;
};

}  // namespace pyrasim::hw
