// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "scene/scene.h"

namespace pyrasim {

/// What this machine has, bytes.
std::uint64_t physical_memory();

/// Throws LimitError where a picture of the window's pixels would take more than `memory` bytes: the samples, and as
/// much again while they are written to a file or hashed.
void check_picture_fits(const PixelWindow& window, std::uint64_t memory = physical_memory());

}  // namespace pyrasim
