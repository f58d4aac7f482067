// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace pyrasim {

/// What terminal nodes took of textures: what the machine pays cycles for.
struct TextureWork {
  std::uint64_t places = 0;  ///< of rays on textured objects, of which coordinates were worked out
  std::uint64_t lines = 0;   ///< of patterns, that the sides of footprints cross, each a step of their integral
  std::uint64_t texels = 0;  ///< of pictures, along the sides of footprints, each a step likewise

  TextureWork& operator+=(const TextureWork& other) {
    places += other.places;
    lines += other.lines;
    texels += other.texels;
    return *this;
  }
  friend bool operator==(const TextureWork&, const TextureWork&) = default;
};

}  // namespace pyrasim
