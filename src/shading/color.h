// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "json/json_reader.h"

namespace pyrasim {

/// The largest value of a component of linear RGB, in files and in pictures.
inline constexpr double max_color = 4096;
inline constexpr NumberRange color_components{0, max_color};

}  // namespace pyrasim
