// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace pyrasim::hw {

/// A stream of zlib (RFC 1950). `level`: from 1, quick, to 9, small.
std::string compressed(std::string_view content, int level);

}  // namespace pyrasim::hw
