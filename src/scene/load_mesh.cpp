// SPDX-License-Identifier: Apache-2.0
#include "scene/load_mesh.h"

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <array>
#include <cstdint>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "error.h"
#include "json/json_file.h"
#include "scene/degenerate.h"
#include "scene/obj_check.h"

namespace pyrasim {
namespace {

std::string read_obj(const std::filesystem::path& file, const std::string& name) {
  try {
    return read_text(file);
  } catch (const std::runtime_error& error) {
    throw InputError(fmt::format("{}: cannot be read: {}; a readable OBJ file is allowed", name, error.what()));
  }
}

/// The faces of `text` as triangles. No material is looked for.
std::vector<tinyobj::shape_t> parse_faces(std::string text, bool triangulate, const std::string& file) {
  tinyobj::attrib_t attributes;
  std::vector<tinyobj::shape_t> shapes;
  std::vector<tinyobj::material_t> materials;
  std::string warning;
  std::string error;
  std::istringstream stream(std::move(text));
  constexpr bool vertex_colors = false;
  if (!tinyobj::LoadObj(&attributes, &shapes, &materials, &warning, &error, &stream, nullptr, triangulate,
                        vertex_colors)) {
    throw InputError(fmt::format("{}: {}; an OBJ file is allowed", file, one_line(error.substr(0, error.find('\n')))));
  }
  return shapes;
}

/// Appends the triangles of `shape` that are not degenerate.
void append(const tinyobj::mesh_t& shape, const std::string& file, Mesh& mesh) {
  for (std::size_t i = 0; i + 2 < shape.indices.size(); i += 3) {
    std::array<std::uint32_t, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = static_cast<std::uint32_t>(shape.indices[i + k].vertex_index);
      // check_obj has seen all faces; this is for a line that the two would read differently.
      if (corners[k] >= mesh.vertices.size()) {
        throw InputError(fmt::format("{}: a face with an index that selects no vertex; 1 to {} is allowed", file,
                                     mesh.vertices.size()));
      }
    }
    const auto& vertices = mesh.vertices;
    if (!is_degenerate(vertices[corners[0]], vertices[corners[1]], vertices[corners[2]])) {
      mesh.triangles.push_back(corners);
    }
  }
}

}  // namespace

LoadedMesh load_mesh(const std::filesystem::path& file) {
  const std::string name = one_line(file.string());
  std::string text = read_obj(file, name);
  ObjOutline outline = check_obj(text, name);
  if (outline.faces == 0) throw InputError(name + ": it has no faces; at least one is needed");
  LoadedMesh loaded;
  loaded.mesh.vertices = std::move(outline.vertices);
  loaded.mesh.triangles.reserve(outline.triangles);
  const bool triangulate = outline.most_corners > 3;
  for (const tinyobj::shape_t& shape : parse_faces(std::move(text), triangulate, name)) {
    append(shape.mesh, name, loaded.mesh);
  }
  if (loaded.mesh.triangles.empty()) {
    throw InputError(name + ": all its faces are degenerate; at least one with an area is needed");
  }
  // Triangles that the triangulation of a folded polygon leaves out have no area that could be seen either.
  loaded.skipped = outline.triangles - loaded.mesh.triangles.size();
  return loaded;
}

}  // namespace pyrasim
