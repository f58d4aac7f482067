// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

namespace pyrasim::hw {

/// The trace page in pieces, one after another, made of page/ when the program is built.
extern const std::span<const std::string_view> page_text;

/// The piece that the runs stand in place of.
inline constexpr std::string_view runs_mark = "<!-- runs -->";

}  // namespace pyrasim::hw
