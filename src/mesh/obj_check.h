// SPDX-License-Identifier: Apache-2.0
// What tinyobjloader does not say: it reads words as zeros and drops faces with wrong indices in silence.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace pyrasim {

/// What a file's faces are made of, and the text that a plain reader needs to read them.
struct ObjOutline {
  struct Face {
    std::size_t line;
    std::uint32_t corners;
  };

  std::vector<glm::dvec3> vertices;
  std::vector<Face> faces;
  std::string plain;  ///< the `v` and `f` lines alone, each on one line, with the vertex indices of corners
  std::vector<std::string> warnings;  ///< of what is not read
};

/// Checks every `v` and `f` line of an OBJ text. Throws InputError "FILE:LINE: what is wrong; what is allowed".
ObjOutline check_obj(std::string_view text, const std::string& file);

}  // namespace pyrasim
