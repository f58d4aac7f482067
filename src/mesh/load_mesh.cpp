// SPDX-License-Identifier: Apache-2.0
#include "mesh/load_mesh.h"

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <array>
#include <cassert>
#include <cstdint>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "error.h"
#include "json/json_file.h"
#include "mesh/degenerate.h"
#include "mesh/obj_check.h"
#include "mesh/triangulate.h"
#include "text/printable.h"

namespace pyrasim {
namespace {

std::string read_obj(const std::filesystem::path& file, const std::string& name) {
  try {
    return read_text(file);
  } catch (const std::runtime_error& error) {
    throw InputError(fmt::format("{}: cannot be read: {}; a readable OBJ file is allowed", name, error.what()));
  }
}

/// The corners of all faces of `text`, as indices of vertices from 0, one face after the other. No material is looked
/// for.
std::vector<tinyobj::index_t> parse_corners(std::string text, const std::string& file) {
  tinyobj::attrib_t attributes;
  std::vector<tinyobj::shape_t> shapes;
  std::vector<tinyobj::material_t> materials;
  std::string warning;
  std::string error;
  std::istringstream stream(std::move(text));
  constexpr bool triangulate = false;
  constexpr bool vertex_colors = false;
  if (!tinyobj::LoadObj(&attributes, &shapes, &materials, &warning, &error, &stream, nullptr, triangulate,
                        vertex_colors)) {
    throw InputError(fmt::format("{}: {}; an OBJ file is allowed", file, excerpt(error.substr(0, error.find('\n')))));
  }
  return shapes.empty() ? std::vector<tinyobj::index_t>() : std::move(shapes.front().mesh.indices);
}

/// Adds the triangles of faces to a mesh whose vertices are known, and counts what is wrong with faces.
class MeshBuilder {
 public:
  explicit MeshBuilder(TriangleMesh& mesh) : mesh_(mesh) {}

  void add(const ObjOutline::Face& face, std::span<const std::uint32_t> corners) {
    const std::size_t before = mesh_.triangles.size();
    bool crossing = false;
    if (corners.size() == 3) {
      add_triangle({corners[0], corners[1], corners[2]});
    } else {
      crossing = add_polygon(corners);
    }
    if (mesh_.triangles.size() == before) {
      ++without_area_;
    } else if (crossing && crossing_++ == 0) {
      first_crossing_ = face.line;
    }
  }

  std::vector<std::string> warnings() const {
    std::vector<std::string> result;
    if (without_area_ > 0) {
      result.push_back(fmt::format("{} faces without an area were skipped; {} triangles are left", without_area_,
                                   mesh_.triangles.size()));
    }
    if (crossing_ > 0) {
      result.push_back(
          fmt::format("{} polygons cross or cover themselves, the first in line {}; what they enclose is "
                      "not defined, and any triangles may be seen",
                      crossing_, first_crossing_));
    }
    return result;
  }

 private:
  void add_triangle(const std::array<std::uint32_t, 3>& corners) {
    const auto& vertices = mesh_.vertices;
    if (!is_degenerate(vertices[corners[0]], vertices[corners[1]], vertices[corners[2]])) {
      mesh_.triangles.push_back(corners);
    }
  }

  /// Whether the polygon crosses itself.
  bool add_polygon(std::span<const std::uint32_t> corners) {
    points_.clear();
    for (const std::uint32_t corner : corners) points_.push_back(mesh_.vertices[corner]);
    const Triangulation polygon = triangulate(points_);
    for (const auto& [i, j, k] : polygon.triangles) add_triangle({corners[i], corners[j], corners[k]});
    return polygon.crossing;
  }

  TriangleMesh& mesh_;
  std::vector<glm::dvec3> points_;  ///< of a polygon
  std::size_t without_area_ = 0;
  std::size_t crossing_ = 0;
  std::size_t first_crossing_ = 0;  ///< its line in the file
};

/// Adds all faces to `mesh` and returns what is to be said of them.
std::vector<std::string> add_faces(ObjOutline& outline, const std::string& file, TriangleMesh& mesh) {
  const std::vector<tinyobj::index_t> indices = parse_corners(std::move(outline.plain), file);
  std::vector<std::uint32_t> corners;
  corners.reserve(indices.size());
  for (const tinyobj::index_t& index : indices) {
    corners.push_back(static_cast<std::uint32_t>(index.vertex_index));
    assert(corners.back() < mesh.vertices.size());  // check_obj has seen all corners
  }
  MeshBuilder builder(mesh);
  std::size_t begin = 0;
  for (const ObjOutline::Face& face : outline.faces) {
    assert(begin + face.corners <= corners.size());
    builder.add(face, std::span(corners).subspan(begin, face.corners));
    begin += face.corners;
  }
  return builder.warnings();
}

}  // namespace

LoadedMesh load_mesh(const std::filesystem::path& file) {
  const std::string name = one_line(file.string());
  ObjOutline outline = check_obj(read_obj(file, name), name);
  if (outline.faces.empty()) throw InputError(name + ": it has no faces; at least one is needed");
  LoadedMesh loaded;
  loaded.mesh.vertices = std::move(outline.vertices);
  loaded.mesh.triangles.reserve(outline.faces.size());
  loaded.warnings = add_faces(outline, name, loaded.mesh);
  if (loaded.mesh.triangles.empty()) {
    throw InputError(name + ": all its faces are degenerate; at least one with an area is needed");
  }
  loaded.warnings.insert(loaded.warnings.end(), outline.warnings.begin(), outline.warnings.end());
  for (std::string& warning : loaded.warnings) warning.insert(0, name + ": ");
  return loaded;
}

}  // namespace pyrasim
