// SPDX-License-Identifier: Apache-2.0
// Meshes that are several objects: by the file's groups, and by its materials, whose borders are edges then.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "scene/read_texture.h"
#include "surface/mesh.h"
#include "surface/reading.h"

namespace pyrasim {

struct MeshObject {
  std::string name;  ///< of its group and its material in the file, with a slash between them
  Mesh mesh;
  glm::dvec3 color;                ///< linear RGB
  std::optional<Texture> texture;  ///< of its material
};

/// Whether an object is split: it says so, or has neither colour nor texture, so that the file's materials count.
bool is_split(const JsonReader& object, const SceneReading& reading);

/// The parts of a mesh that is_split(); `color` is that of all, where the materials do not count. Throws InputError.
std::vector<MeshObject> read_mesh_objects(const JsonReader& object, const std::optional<glm::dvec3>& color,
                                          const SceneReading& reading, TextureReader& textures);

}  // namespace pyrasim
