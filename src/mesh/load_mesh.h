// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/obj_file.h"
#include "mesh/triangle_mesh.h"

namespace pyrasim {

/// What an OBJ file says of a triangle beside where it is.
struct TriangleMark {
  std::uint32_t group;     ///< among the file's groups
  std::uint32_t material;  ///< among its materials, or no_value
};

struct LoadedMesh {
  TriangleMesh mesh;
  std::vector<TriangleMark> marks;  ///< by triangle
  std::vector<ObjFile::Name> groups, materials, libraries;
  std::size_t groups_met = 0, materials_met = 0;  ///< that triangles have
  std::vector<std::string> warnings;  ///< "FILE: what is lost; what is left": faces without area, polygons that cross
                                      ///< themselves, what is not read of the file

  /// What is to be said of what an object leaves of the file: its materials, and that it is one object.
  std::vector<std::string> unused(const std::string& file, bool materials_used, bool groups_used) const;
};

/// Reads an OBJ file; polygons become triangles (see triangulate.h). Throws InputError "FILE: what is wrong; what is
/// allowed" or "FILE:LINE: ...": a file that cannot be read, no faces or degenerate ones only, a face with an index
/// that selects nothing, coordinates that are no finite numbers.
LoadedMesh load_mesh(const std::filesystem::path& file);
/// The same of a file's text; `name` is the file's.
LoadedMesh read_mesh(std::string_view text, const std::string& name);

}  // namespace pyrasim
