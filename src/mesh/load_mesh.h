// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace pyrasim {

struct LoadedMesh {
  TriangleMesh mesh;
  std::vector<std::string> warnings;  ///< "FILE: what is lost; what is left": faces without area, polygons that cross
                                      ///< themselves, what is not read of the file
};

/// Reads the vertices and faces of an OBJ file; polygons become triangles (see triangulate.h), and groups and materials
/// are passed over. Throws InputError "FILE: what is wrong; what is allowed" or "FILE:LINE: ...": a file that cannot be
/// read, no faces or degenerate ones only, a face with an index that selects no vertex, coordinates that are no finite
/// numbers.
LoadedMesh load_mesh(const std::filesystem::path& file);

}  // namespace pyrasim
