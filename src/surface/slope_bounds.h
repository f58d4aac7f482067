// SPDX-License-Identifier: Apache-2.0
// Bounds as the observer sees them. Every view ray starts at the origin, so along it the slopes y / x and z / x do not
// change: in the coordinates (depth x, slope y / x, slope z / x) all view rays run parallel to the first axis, and
// whether one meets a box takes comparisons only.
#pragma once

#include <span>

#include "camera/camera.h"
#include "surface/bounding_box.h"

namespace pyrasim {

/// The sphere grown by `margin`, in slope space. Sides that the observer's plane x = 0 cuts are infinite; the
/// bounds of what lies behind it are empty.
BoundingBox slope_bounds_of_sphere(const glm::dvec3& center, double radius, double margin);

/// The hull of `points` grown by `margin` along each axis, likewise.
BoundingBox slope_bounds_of_hull(std::span<const glm::dvec3> points, double margin);

/// What of slope-space bounds lies on the screen, where all rays of a picture are; off the screen a point of its
/// border.
BoundingBox on_screen(const BoundingBox& seen, const Screen& screen);

}  // namespace pyrasim
