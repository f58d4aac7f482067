// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <type_traits>

#include "surface/list.h"

namespace pyrasim {

/// Of whatever kind the surface is then. Throws MapError.
inline SceneSurface transformed(const SceneSurface& surface, const AffineMap& map) {
  const auto by_map = [&](const auto& description) -> SceneSurface {
    const auto mapped = description.transformed(map);
    if constexpr (std::is_constructible_v<SceneSurface, decltype(mapped)>) {
      return mapped;
    } else {
      return std::visit([](const auto& alternative) { return SceneSurface(alternative); }, mapped);
    }
  };
  return std::visit(by_map, surface);
}

}  // namespace pyrasim
