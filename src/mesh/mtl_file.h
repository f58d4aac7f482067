// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pyrasim {

/// A picture that a material's colour is multiplied by: its texture coordinate is the surface's, times `scale`, plus
/// `offset`.
struct MaterialMap {
  std::string file;  ///< as the MTL file names it, with / between folders
  bool clamp = false;
  glm::dvec2 scale{1};
  glm::dvec2 offset{0};
  std::string line;  ///< "FILE:LINE" that says it
};

/// What of a material is modelled: how much of each light it throws back in all directions.
struct Material {
  std::string name;
  glm::dvec3 color{1};             ///< `Kd`, linear RGB
  std::optional<MaterialMap> map;  ///< `map_Kd`
};

struct MtlFile {
  std::vector<Material> materials;    ///< of those of one name the first counts
  std::vector<std::string> warnings;  ///< "FILE: ..." of what changes a picture and is not read
};

/// Reads an MTL text. Throws InputError "FILE:LINE: what is wrong; what is allowed".
MtlFile read_mtl(std::string_view text, const std::string& file);

}  // namespace pyrasim
