// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace pyrasim {

/// SHA-256 of `bytes`, in hexadecimal.
std::string sha256(std::string_view bytes);

}  // namespace pyrasim
