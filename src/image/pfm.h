// SPDX-License-Identifier: Apache-2.0
// Portable float maps: a text header ("PF", size, scale), then float32 samples, bottom row first.
#pragma once

#include <filesystem>
#include <string>

#include "image/image.h"

namespace pyrasim {

/// The bytes of `image` as a little-endian colour PFM of scale 1.
std::string encode_pfm(const Image& image);

/// Reads a colour (PF) or grey (Pf) map of either byte order; samples are multiplied by the header's scale.
/// Throws InputError "FILE: what is wrong; what is allowed".
Image read_pfm(const std::filesystem::path& file);

}  // namespace pyrasim
