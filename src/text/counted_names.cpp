// SPDX-License-Identifier: Apache-2.0
#include "text/counted_names.h"

#include <fmt/format.h>

#include "text/printable.h"

namespace pyrasim {
namespace {

constexpr std::size_t most_names = 8;     ///< that a list has
constexpr std::size_t longest_name = 20;  ///< characters

}  // namespace

void CountedNames::add(std::string_view name, std::size_t count) {
  if (count == 0) return;
  if (++names_ > most_names) return;
  text_ += fmt::format("{}{} {}", text_.empty() ? "" : ", ", excerpt(name, longest_name), count);
}

std::string CountedNames::text() const {
  return names_ > most_names ? fmt::format("{} and {} more", text_, names_ - most_names) : text_;
}

}  // namespace pyrasim
