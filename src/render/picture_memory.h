// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "scene/scene.h"

namespace pyrasim {

/// What this machine has, bytes.
std::uint64_t physical_memory();

/// Throws LimitError where what is held of the window's pixels at once would take more than `memory` bytes: their
/// samples twice, as a picture and while that is written to a file, or as a picture and what it is measured against;
/// and `maps` bytes of what is kept of pixels beside.
void check_picture_fits(const PixelWindow& window, std::uint64_t memory = physical_memory(), std::uint64_t maps = 0);

/// Pictures of which `at_once` are made at the same time, any of them beside each other. Throws LimitError where one
/// does not fit, or the largest of them together with the `references` that these can be measured against: as many, or
/// all.
void check_pictures_fit(const std::vector<PixelWindow>& pictures, const std::vector<PixelWindow>& references,
                        int at_once, std::uint64_t memory = physical_memory());

}  // namespace pyrasim
