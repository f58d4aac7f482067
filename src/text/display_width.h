// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <string_view>

namespace pyrasim {

/// Columns of a terminal that `text` (UTF-8) takes, as fmt counts them where it pads a text: one a character, two for
/// those of East Asian width. Never more than bytes.
inline std::size_t display_width(std::string_view text) {
  const std::size_t padding = fmt::formatted_size("{:<{}}", text, text.size()) - text.size();
  return text.size() - padding;
}

}  // namespace pyrasim
