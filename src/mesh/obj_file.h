// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace pyrasim {

/// What an OBJ file says of polygons.
struct ObjFile {
  /// A corner of a face: indices from 0 into vertices, places and normals; the last two may be no_value.
  struct Corner {
    std::uint32_t vertex, place, normal;
  };
  struct Face {
    std::size_t line;
    std::uint32_t corners;   ///< how many; they follow those of the face before
    std::uint32_t group;     ///< among groups
    std::uint32_t material;  ///< among materials, or no_value
  };
  struct Name {
    std::string text;
    std::size_t line;  ///< the first that says it
  };

  std::vector<glm::dvec3> vertices;  ///< `v`
  std::vector<glm::dvec2> places;    ///< `vt`
  std::vector<glm::dvec3> normals;   ///< `vn`
  std::vector<Corner> corners;       ///< `f`
  std::vector<Face> faces;
  std::vector<Name> groups;     ///< of `o` and `g`: both names with a slash between them; the first is "", before both
  std::vector<Name> materials;  ///< of `usemtl`
  std::vector<Name> libraries;  ///< of `mtllib`: what follows the word, one name or several
  std::vector<std::string> warnings;  ///< of what is not read
};

/// Reads an OBJ text. Throws InputError "FILE:LINE: what is wrong; what is allowed".
///
/// It is read here because well-kept readers take words for zeros and drop faces with wrong indices in silence: what it
/// takes to find these is the reading.
ObjFile read_obj(std::string_view text, const std::string& file);

}  // namespace pyrasim
