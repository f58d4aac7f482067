// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mesh/load_mesh.h"
#include "mesh/mtl_file.h"

namespace pyrasim {

struct LoadedMaterials {
  std::vector<Material> materials;    ///< by the mesh's number of them; paths of maps are relative to where the mesh's
                                      ///< path is
  std::vector<std::string> files;     ///< that they were read from
  std::vector<std::string> warnings;  ///< one line each
};

/// The materials that a mesh names, from its libraries; the first that has one counts. `file` is the mesh's. Throws
/// InputError "FILE:LINE: ...": a library that cannot be read, a material that none of them has, and what read_mtl()
/// does.
LoadedMaterials load_materials(const LoadedMesh& mesh, const std::filesystem::path& file);

}  // namespace pyrasim
