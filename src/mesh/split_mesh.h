// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/load_mesh.h"

namespace pyrasim {

/// A part of a mesh, with the vertices that it has.
struct MeshPart {
  std::uint32_t group;     ///< among the mesh's, or no_value
  std::uint32_t material;  ///< likewise
  TriangleMesh mesh;
};

/// The mesh's triangles apart, by group, material, or both, in the order in which parts come up in the file.
std::vector<MeshPart> split_mesh(const LoadedMesh& mesh, bool by_group, bool by_material);

}  // namespace pyrasim
