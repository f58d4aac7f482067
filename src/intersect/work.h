// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <numeric>

#include "shading/light.h"
#include "surface/list.h"

namespace pyrasim {

/// Tests made to find what rays meet.
struct Tests {
  std::uint64_t box_tests = 0;                               ///< bounding boxes tested
  std::array<std::uint64_t, surface_kinds> surface_tests{};  ///< by SurfaceKind

  Tests& operator+=(const Tests& other) {
    box_tests += other.box_tests;
    for (std::size_t kind = 0; kind < surface_kinds; ++kind) surface_tests[kind] += other.surface_tests[kind];
    return *this;
  }
  friend bool operator==(const Tests&, const Tests&) = default;
};

/// Rays from the places that are seen to the lights.
struct ShadowWork {
  std::array<std::uint64_t, max_shadow_lights> rays{};  ///< by light, in the order of those with shadows
  Tests tests;

  std::uint64_t total_rays() const { return std::accumulate(rays.begin(), rays.end(), std::uint64_t{0}); }
  ShadowWork& operator+=(const ShadowWork& other) {
    for (std::size_t light = 0; light < rays.size(); ++light) rays[light] += other.rays[light];
    tests += other.tests;
    return *this;
  }
  friend bool operator==(const ShadowWork&, const ShadowWork&) = default;
};

/// The work that one ray or one frame took: what the machine pays cycles for. Its own tests are those of view rays.
struct Work : Tests {
  ShadowWork shadow{};

  Work& operator+=(const Work& other) {
    Tests::operator+=(other);
    shadow += other.shadow;
    return *this;
  }
  friend bool operator==(const Work&, const Work&) = default;
};

}  // namespace pyrasim
