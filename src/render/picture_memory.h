// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "scene/scene.h"

namespace pyrasim {

/// What this machine has, bytes.
std::uint64_t physical_memory();

/// Throws LimitError where `pictures` of the window's pixels, held at once, would take more than `memory` bytes: the
/// samples of each, and as much again for one while it is written to a file or hashed.
void check_picture_fits(const PixelWindow& window, std::uint64_t memory = physical_memory(), std::size_t pictures = 1);

}  // namespace pyrasim
