// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace pyrasim {

inline constexpr std::uint32_t no_object = 0xFFFFFFFFU;

/// What a ray brings back: the identity that decides the case (decision D4) and how brightly the surface is lit there.
struct Sample {
  std::uint32_t object = no_object;  ///< index into the scene's objects
  double shading = 1;                ///< factor on the object's colour, 0 to 1
  friend bool operator==(const Sample&, const Sample&) = default;
};

}  // namespace pyrasim
