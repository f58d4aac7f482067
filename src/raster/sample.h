// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "raster/shading.h"

namespace pyrasim {

inline constexpr std::uint32_t no_object = 0xFFFFFFFFU;

/// What a ray sees, and what decides the case: where corners see the same, there is no border between them.
struct Seen {
  std::uint32_t object = no_object;  ///< index into the scene's objects (decision D4)
  std::uint32_t lights = 0;          ///< those with shadows that reach the place, a bit each (decision D5)
  friend bool operator==(const Seen&, const Seen&) = default;
};

/// What a ray brings back. Two words, which a function returns in registers.
struct Sample {
  Seen seen;
  Shading shading{};
  friend bool operator==(const Sample&, const Sample&) = default;
};

}  // namespace pyrasim
