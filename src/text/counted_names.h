// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace pyrasim {

/// "g 2, o 1": a list of what was counted in a file, not longer than a line.
class CountedNames {
 public:
  void add(std::string_view name, std::size_t count);

  bool empty() const { return names_ == 0; }
  std::string text() const;

 private:
  std::string text_;
  std::size_t names_ = 0;
};

}  // namespace pyrasim
