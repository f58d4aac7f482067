// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace pyrasim {

/// The largest magnitude of a coordinate, world units: the squares of differences stay far from the end of double.
inline constexpr double max_coordinate = 1e30;

/// The smallest length that is told from zero, world units: its square is far from the smallest double.
inline constexpr double min_length = 1e-30;

}  // namespace pyrasim
