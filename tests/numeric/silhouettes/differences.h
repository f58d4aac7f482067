// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include "intersect/intersector.h"
#include "oracle.h"

namespace pyrasim::silhouettes {

/// Rays that come back with another object than the oracle's.
struct Differences {
  std::size_t all = 0;  ///< rays traced
  std::size_t different = 0;
  std::size_t unexplained = 0;  ///< of the different ones: the exact margin is larger than the error bound
  double largest_error = 0;     ///< of the explained ones, as a part of its bound
  std::string first_unexplained;
};

struct FrameDifferences {
  Differences rays;
  std::size_t pyramids = 0;            ///< pixels and subpixels
  std::size_t different_pyramids = 0;  ///< of another case than by the oracle's objects
};

/// Of a frame as `intersector`, which computes in `format`, renders it.
FrameDifferences differences_in_frame(const Intersector& intersector, const NumberFormat& format, Oracle& oracle);

/// Of rays on both sides of where `intersector` sees the outline of an object, as close to it as doubles are.
Differences differences_by_outline(const Intersector& intersector, const NumberFormat& format, Oracle& oracle);

}  // namespace pyrasim::silhouettes
