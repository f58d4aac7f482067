// SPDX-License-Identifier: Apache-2.0
#include "mesh/load_mesh.h"

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "error.h"
#include "json/json_file.h"
#include "mesh/degenerate.h"
#include "mesh/triangulate.h"
#include "text/counted.h"
#include "text/printable.h"

namespace pyrasim {
namespace {

std::string read_text_of(const std::filesystem::path& file, const std::string& name) {
  try {
    return read_text(file);
  } catch (const std::runtime_error& error) {
    throw InputError(fmt::format("{}: cannot be read: {}; a readable OBJ file is allowed", name, error.what()));
  }
}

/// Adds the triangles of faces to a mesh whose values are known, and counts what is wrong with faces.
class MeshBuilder {
 public:
  explicit MeshBuilder(LoadedMesh& loaded) : loaded_(loaded), mesh_(loaded.mesh) {}

  void add(const ObjFile::Face& face, std::span<const ObjFile::Corner> corners) {
    const std::size_t before = mesh_.triangles.size();
    bool crossing = false;
    if (corners.size() == 3) {
      add_triangle(face, {corners[0], corners[1], corners[2]});
    } else {
      crossing = add_polygon(face, corners);
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
      result.push_back(fmt::format("{} without an area {} skipped; {} {} left", counted(without_area_, "face"),
                                   of_number(without_area_, "was", "were"), counted(mesh_.triangles.size(), "triangle"),
                                   of_number(mesh_.triangles.size(), "is", "are")));
    }
    if (crossing_ > 0) {
      result.push_back(crossing_warning(crossing_, first_crossing_));
    }
    return result;
  }

 private:
  void add_triangle(const ObjFile::Face& face, const std::array<ObjFile::Corner, 3>& corners) {
    const auto& [a, b, c] = corners;
    const auto& vertices = mesh_.vertices;
    if (is_degenerate(vertices[a.vertex], vertices[b.vertex], vertices[c.vertex])) return;
    mesh_.triangles.push_back({a.vertex, b.vertex, c.vertex});
    loaded_.marks.push_back({face.group, face.material});
    add_values(mesh_.places, {a.place, b.place, c.place});
    add_values(mesh_.normals, {a.normal, b.normal, c.normal});
  }

  /// Of the triangle that was added last; those before it have none, where they had none.
  template <class Value>
  void add_values(CornerValues<Value>& values, const TriangleCorners& corners) {
    if (values.empty() && corners == no_values) return;
    values.corners.resize(mesh_.triangles.size(), no_values);
    values.corners.back() = corners;
  }

  /// Whether the polygon crosses itself.
  bool add_polygon(const ObjFile::Face& face, std::span<const ObjFile::Corner> corners) {
    points_.clear();
    for (const ObjFile::Corner& corner : corners) points_.push_back(mesh_.vertices[corner.vertex]);
    const Triangulation polygon = triangulate(points_);
    for (const auto& [i, j, k] : polygon.triangles) add_triangle(face, {corners[i], corners[j], corners[k]});
    return polygon.crossing;
  }

  static constexpr TriangleCorners no_values{no_value, no_value, no_value};

  LoadedMesh& loaded_;
  TriangleMesh& mesh_;
  std::vector<glm::dvec3> points_;  ///< of a polygon
  std::size_t without_area_ = 0;
  std::size_t crossing_ = 0;
  std::size_t first_crossing_ = 0;  ///< its line in the file
};

/// Once for all objects of the file.
void count_names(LoadedMesh& loaded) {
  std::set<std::uint32_t> groups, materials;
  for (const TriangleMark& mark : loaded.marks) {
    groups.insert(mark.group);
    if (mark.material != no_value) materials.insert(mark.material);
  }
  loaded.groups_met = groups.size();
  loaded.materials_met = materials.size();
}

}  // namespace

std::vector<std::string> LoadedMesh::unused(const std::string& file, bool materials_used, bool groups_used) const {
  std::vector<std::string> result;
  if (materials_met > 0 && !materials_used) {
    result.push_back(
        fmt::format("{}: materials are not used ({}), since the object has a color or a texture", file, materials_met));
  }
  if (groups_met > 1 && !materials_used && !groups_used) {
    result.push_back(
        fmt::format(R"({}: groups are one object ({}); with "split": "groups" each is one)", file, groups_met));
  }
  return result;
}

LoadedMesh load_mesh(const std::filesystem::path& file) {
  const std::string name = one_line(file.string());
  return read_mesh(read_text_of(file, name), name);
}

LoadedMesh read_mesh(std::string_view text, const std::string& name) {
  ObjFile obj = read_obj(text, name);
  if (obj.faces.empty()) throw InputError(name + ": it has no faces; at least one is needed");
  LoadedMesh loaded;
  loaded.mesh.vertices = std::move(obj.vertices);
  loaded.mesh.places.values = std::move(obj.places);
  loaded.mesh.normals.values = std::move(obj.normals);
  loaded.mesh.triangles.reserve(obj.faces.size());
  loaded.marks.reserve(obj.faces.size());
  MeshBuilder builder(loaded);
  std::size_t begin = 0;
  for (const ObjFile::Face& face : obj.faces) {
    builder.add(face, std::span(obj.corners).subspan(begin, face.corners));
    begin += face.corners;
  }
  if (loaded.mesh.triangles.empty()) {
    throw InputError(name + ": all its faces are degenerate; at least one with an area is needed");
  }
  count_names(loaded);
  loaded.groups = std::move(obj.groups);
  loaded.materials = std::move(obj.materials);
  loaded.libraries = std::move(obj.libraries);
  loaded.warnings = builder.warnings();
  loaded.warnings.insert(loaded.warnings.end(), obj.warnings.begin(), obj.warnings.end());
  for (std::string& warning : loaded.warnings) warning.insert(0, name + ": ");
  return loaded;
}

}  // namespace pyrasim
