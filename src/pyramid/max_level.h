// SPDX-License-Identifier: Apache-2.0
// How deep to subdivide: the article's criterion.
#pragma once

#include "scene/scene.h"

namespace pyrasim {

/// The angle that the eye resolves, radians: about 2^-13 (Ferwerda 2001, the article's source).
inline constexpr double eye_resolution = 1.0 / 8192;

/// MAX_LEVEL = ceil(log2(angle of a pixel / angle the eye resolves)), at least 0: each level halves the subpixel, so
/// this is the first at which the staircase is too fine to be seen. Angles in radians, above 0.
int required_max_level(double pixel_angle, double resolved_angle = eye_resolution);

/// The angle of a pixel of side `pixel_size` seen from `distance` straight ahead, radians.
double pixel_angle(double pixel_size, double distance);

/// The angle of a screen's pixel (its longer side) seen from the centre of projection.
double pixel_angle(const Screen& screen);

}  // namespace pyrasim
