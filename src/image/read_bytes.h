// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace pyrasim {

/// The most bytes, and the most pixels, that a picture file may have.
constexpr std::size_t max_file_bytes = std::size_t{1} << 31U;
constexpr std::size_t max_pixels = std::size_t{1} << 28U;

/// All bytes of `file`. Throws InputError "FILE: cannot read: reason".
std::string read_bytes(const std::filesystem::path& file);

}  // namespace pyrasim
