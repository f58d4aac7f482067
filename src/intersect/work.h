// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "surface/list.h"

namespace pyrasim {

/// The work that one ray or one frame took: what the machine's intersection units pay cycles for.
struct Work {
  std::uint64_t box_tests = 0;                               ///< bounding boxes tested
  std::array<std::uint64_t, surface_kinds> surface_tests{};  ///< by SurfaceKind

  Work& operator+=(const Work& other) {
    box_tests += other.box_tests;
    for (std::size_t kind = 0; kind < surface_kinds; ++kind) surface_tests[kind] += other.surface_tests[kind];
    return *this;
  }
  friend bool operator==(const Work&, const Work&) = default;
};

}  // namespace pyrasim
