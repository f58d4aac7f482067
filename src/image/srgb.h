// SPDX-License-Identifier: Apache-2.0
// The sRGB transfer functions, IEC 61966-2-1. Both take and give numbers from 0 to 1.
#pragma once

#include <cmath>

namespace pyrasim {

/// The sRGB signal that shows the linear intensity `linear`.
inline double srgb_from_linear(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

/// The linear intensity that the sRGB signal `signal` stands for.
inline double linear_from_srgb(double signal) {
  return signal <= 0.04045 ? signal / 12.92 : std::pow((signal + 0.055) / 1.055, 2.4);
}

}  // namespace pyrasim
