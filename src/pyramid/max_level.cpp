// SPDX-License-Identifier: Apache-2.0
#include "pyramid/max_level.h"

#include <algorithm>
#include <cmath>

namespace pyrasim {

int required_max_level(double pixel_angle, double resolved_angle) {
  return std::max(0, static_cast<int>(std::ceil(std::log2(pixel_angle / resolved_angle))));
}

double pixel_angle(double pixel_size, double distance) { return 2 * std::atan(pixel_size / (2 * distance)); }

double pixel_angle(const Screen& screen) { return pixel_angle(std::max(screen.dy, screen.dz), screen.dx); }

}  // namespace pyrasim
