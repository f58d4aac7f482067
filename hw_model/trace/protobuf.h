// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "hw_model/record/varint.h"

namespace pyrasim::hw {

/// A message of Protocol Buffers, field by field (protobuf.dev, Encoding).
class Protobuf {
 public:
  void number(unsigned field, std::uint64_t value) {
    varint(field << 3U);
    varint(value);
  }
  /// Of a field of type fixed64.
  void fixed(unsigned field, std::uint64_t value) {
    varint(field << 3U | 1U);
    for (unsigned k = 0; k < 8; ++k) bytes_ += static_cast<char>(value >> (8 * k));
  }
  void text(unsigned field, std::string_view value) {
    varint(field << 3U | 2U);
    varint(value.size());
    bytes_ += value;
  }
  void message(unsigned field, const Protobuf& value) { text(field, value.bytes_); }

  const std::string& bytes() const { return bytes_; }
  void clear() { bytes_.clear(); }

 private:
  void varint(std::uint64_t value) { append_varint(bytes_, value); }

  std::string bytes_;
};

}  // namespace pyrasim::hw
