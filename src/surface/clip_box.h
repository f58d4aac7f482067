// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "numeric/quadruple.h"
#include "surface/bounding_box.h"

namespace pyrasim {

/// Beyond all coordinates.
inline constexpr double beyond_all = 0x1p140;

/// The points p with normal . p <= offset.
struct ExactHalfSpace {
  QuadrupleVector normal;  ///< of any length
  Quadruple offset;
};

/// The box about what half-spaces leave of `box`, or of the whole space; it reaches as far as `beyond_all` where what
/// is left has no bounds. None where nothing is left.
std::optional<BoundingBox> clip_box(std::span<const ExactHalfSpace> clip, const std::optional<BoundingBox>& box);

}  // namespace pyrasim
