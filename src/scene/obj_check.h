// SPDX-License-Identifier: Apache-2.0
// What tinyobjloader does not say: it reads words as zeros and drops faces with wrong indices in silence.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace pyrasim {

/// The vertices of an OBJ text and the size of its faces.
struct ObjOutline {
  std::vector<glm::dvec3> vertices;
  std::size_t faces = 0;
  std::size_t triangles = 0;     ///< after triangulation: the sum of (corners - 2)
  std::size_t most_corners = 0;  ///< of a face
};

/// Checks every `v` and `f` line of an OBJ text. Throws InputError "FILE:LINE: what is wrong; what is allowed".
ObjOutline check_obj(std::string_view text, const std::string& file);

}  // namespace pyrasim
