// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "study/format_study.h"

namespace pyrasim {

/// An SVG picture: changed pixels and flipped decisions against the bits that a format has after the binary point of 1
/// (floating point: P - 1; fixed point: F), on a logarithmic axis that begins with 0. `title` heads it.
std::string format_plot(const std::vector<FormatRow>& rows, const std::string& title);

}  // namespace pyrasim
