// SPDX-License-Identifier: Apache-2.0
#include "surface/mesh.h"

#include <fmt/format.h>

#include <utility>

#include "error.h"
#include "mesh/degenerate.h"
#include "mesh/load_mesh.h"
#include "surface/affine_map.h"
#include "surface/pov_writer.h"

namespace pyrasim {

Mesh Mesh::read(const JsonReader& reader, const SceneReading& reading) {
  const JsonReader file = reader.member("file");
  const std::string name = file.string();
  if (name.empty() || name.find('\0') != std::string::npos) {
    file.fail("the path is empty or holds a null character", "the path of an OBJ file is allowed");
  }
  const std::string path = (reading.folder / name).string();
  if (const auto known = reading.meshes.find(path); known != reading.meshes.end()) return {known->second};
  try {
    LoadedMesh loaded = load_mesh(path);
    reading.files.push_back(path);
    for (const std::string& warning : loaded.warnings) {
      reading.warnings.push_back(fmt::format("{}: {}: {}", file.file(), file.pointer(), warning));
    }
    return {reading.meshes.emplace(path, std::move(loaded.mesh)).first->second};
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}: {}", file.file(), file.pointer(), error.what()));
  }
}

Mesh Mesh::transformed(const AffineMap& map) const {
  Mesh mapped = *this;
  for (glm::dvec3& vertex : mapped.vertices) vertex = mapped_point(map, vertex);
  std::erase_if(mapped.triangles, [&](const auto& triangle) {
    const auto& [a, b, c] = triangle;
    return is_degenerate(mapped.vertices[a], mapped.vertices[b], mapped.vertices[c]);
  });
  if (mapped.triangles.empty()) fail_without_area();
  return mapped;
}

void Mesh::write_pov(PovWriter& pov) const {
  pov.begin("mesh2");
  pov.begin("vertex_vectors");
  pov.add(static_cast<double>(vertices.size()));
  for (const glm::dvec3& vertex : vertices) pov.add_line(vertex);
  pov.end();
  pov.begin("face_indices");
  pov.add(static_cast<double>(triangles.size()));
  for (const auto& [a, b, c] : triangles) pov.add_line(glm::dvec3(a, b, c));
  pov.end();
  pov.end();
}

}  // namespace pyrasim
