// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "image/image.h"

namespace pyrasim {

/// How far a picture is from its reference, over all linear RGB components.
struct ImageError {
  double rmse = 0;     // root of the mean squared difference
  double maximum = 0;  // greatest absolute difference
};

/// Throws UsageError where the sizes differ. A component that is not a number in either picture is infinitely far off.
ImageError image_error(const Image& image, const Image& reference);

/// Peak signal-to-noise ratio in decibels for a peak of 1: infinite where the pictures are equal.
double psnr(const Image& image, const Image& reference);

/// Pixels that differ in a PNG of 8 bits, sRGB. Throws UsageError where the sizes differ.
std::uint64_t changed_pixels(const Image& image, const Image& reference);

/// Throws UsageError "COLUMNSxROWS and COLUMNSxROWS: ..." where the sizes differ.
void check_same_size(const Image& a, const Image& b);

}  // namespace pyrasim
