// SPDX-License-Identifier: Apache-2.0
#include "surface/mesh.h"

#include <algorithm>
#include <utility>

#include "mesh/degenerate.h"
#include "numeric/vectors.h"
#include "surface/affine_map.h"
#include "surface/mesh_file.h"
#include "surface/pov_writer.h"

namespace pyrasim {
namespace {

/// To components of at most 1, all by one factor.
template <class Vectors>
void shorten(Vectors& vectors) {
  double longest = 0;
  for (const glm::dvec3& v : vectors) longest = std::max(longest, largest(v));
  for (glm::dvec3& v : vectors) v /= longest;
}

}  // namespace

Mesh Mesh::read(const JsonReader& reader, const SceneReading& reading) {
  if (const auto split = reader.find("split")) {
    split->fail("a shape is one surface", "meshes of objects may be split");
  }
  const JsonReader file = reader.member("file");
  const LoadedMesh& loaded = mesh_of_file(file, reading);
  warn_of_unused(file, reading, false, false);
  return of(loaded.mesh, reader);
}

Mesh Mesh::of(TriangleMesh part, const JsonReader& reader) {
  Mesh mesh{std::move(part)};
  if (!reader.optional_boolean("smooth").value_or(false)) {
    mesh.normals = {};
    return mesh;
  }
  const JsonReader smooth = reader.member("smooth");
  if (!all_have(mesh.normals)) {
    smooth.fail("some faces of the mesh have no normals (vn) at their corners", "normals of all, or false, are needed");
  }
  for (const TriangleCorners& corners : mesh.normals.corners) {
    for (const std::uint32_t corner : corners) {
      if (largest(mesh.normals.values[corner]) > 0) continue;
      smooth.fail("a normal of the mesh has no length", "normals with a direction, or false, are needed");
    }
  }
  for (glm::dvec3& normal : mesh.normals.values) {  // those that no face selects may have no direction
    normal = largest(normal) > 0 ? normalized(normal) : glm::dvec3(0, 1, 0);
  }
  return mesh;
}

std::shared_ptr<const VertexNormals<double>> Mesh::observed_normals(std::size_t triangle,
                                                                    const ObserverFrame& frame) const {
  VertexNormals<double> observed = normals.of(triangle);
  for (auto& normal : observed) normal = frame.direction(normal);
  shorten(observed);
  return std::make_shared<const VertexNormals<double>>(observed);
}

/// Normals keep their lengths beside each other: so that between them, too, is what would be mapped to there.
Mesh Mesh::transformed(const AffineMap& map) const {
  Mesh mapped = *this;
  for (glm::dvec3& vertex : mapped.vertices) vertex = mapped_point(map, vertex);
  for (glm::dvec3& normal : mapped.normals.values) normal = rounded(map.normal(exactly(normal)));
  shorten(mapped.normals.values);
  mapped.erase_triangles(is_degenerate);
  if (mapped.triangles.empty()) fail_without_area();
  return mapped;
}

void Mesh::write_pov(PovWriter& pov) const {
  const auto write = [&](std::string_view name, const auto& list, const auto& vector_of) {
    pov.begin(name);
    pov.add(static_cast<double>(list.size()));
    for (const auto& element : list) pov.add_line(vector_of(element));
    pov.end();
  };
  const auto itself = [](const glm::dvec3& v) { return v; };
  const auto indices = [](const TriangleCorners& corners) { return glm::dvec3(corners[0], corners[1], corners[2]); };
  pov.begin("mesh2");
  write("vertex_vectors", vertices, itself);
  if (!normals.empty()) write("normal_vectors", normals.values, itself);
  write("face_indices", triangles, indices);
  if (!normals.empty()) write("normal_indices", normals.corners, indices);
  pov.end();
}

}  // namespace pyrasim
