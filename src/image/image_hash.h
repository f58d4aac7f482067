// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "image/image.h"

namespace pyrasim {

/// SHA-256, in lower-case hexadecimal, of the linear RGB samples as little-endian float32, top row first.
std::string image_sha256(const Image& image);

}  // namespace pyrasim
