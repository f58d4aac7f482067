// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "scene/scene.h"

namespace pyrasim {

/// What this machine has, bytes.
std::uint64_t physical_memory();

/// Throws LimitError where what is held of the window's pixels at once would take more than `memory` bytes: their
/// samples twice, as a picture and while that is written to a file or hashed, or as a picture and what it is measured
/// against.
void check_picture_fits(const PixelWindow& window, std::uint64_t memory = physical_memory());

}  // namespace pyrasim
