// SPDX-License-Identifier: Apache-2.0
#include "mesh/split_mesh.h"

#include <cstddef>
#include <map>
#include <utility>

namespace pyrasim {
namespace {

/// Takes what triangles select out of a list, each value once.
template <class Value>
class Selection {
 public:
  Selection(const std::vector<Value>& from, const std::vector<TriangleCorners>& corners, std::vector<Value>& to,
            std::vector<TriangleCorners>& selected)
      : from_(from), corners_(corners), to_(to), selected_(selected) {}

  void add(std::size_t triangle) {
    if (corners_.empty()) return;
    TriangleCorners& selected = selected_.emplace_back();
    for (std::size_t k = 0; k < selected.size(); ++k) selected[k] = number_of(corners_[triangle][k]);
  }

 private:
  std::uint32_t number_of(std::uint32_t index) {
    if (index == no_value) return index;
    const auto [known, is_new] = numbers_.emplace(index, static_cast<std::uint32_t>(to_.size()));
    if (is_new) to_.push_back(from_[index]);
    return known->second;
  }

  const std::vector<Value>& from_;
  const std::vector<TriangleCorners>& corners_;
  std::vector<Value>& to_;
  std::vector<TriangleCorners>& selected_;
  std::map<std::uint32_t, std::uint32_t> numbers_;
};

TriangleMesh selected(const TriangleMesh& mesh, const std::vector<std::size_t>& triangles) {
  TriangleMesh part;
  Selection vertices(mesh.vertices, mesh.triangles, part.vertices, part.triangles);
  Selection places(mesh.places.values, mesh.places.corners, part.places.values, part.places.corners);
  Selection normals(mesh.normals.values, mesh.normals.corners, part.normals.values, part.normals.corners);
  for (const std::size_t triangle : triangles) {
    vertices.add(triangle);
    places.add(triangle);
    normals.add(triangle);
  }
  return part;
}

}  // namespace

std::vector<MeshPart> split_mesh(const LoadedMesh& mesh, bool by_group, bool by_material) {
  struct Triangles {
    std::uint32_t group, material;
    std::vector<std::size_t> numbers;
  };
  std::vector<Triangles> parts;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> known;
  for (std::size_t k = 0; k < mesh.marks.size(); ++k) {
    const std::uint32_t group = by_group ? mesh.marks[k].group : no_value;
    const std::uint32_t material = by_material ? mesh.marks[k].material : no_value;
    const auto [part, is_new] = known.emplace(std::pair(group, material), parts.size());
    if (is_new) parts.push_back({group, material, {}});
    parts[part->second].numbers.push_back(k);
  }
  std::vector<MeshPart> result;
  result.reserve(parts.size());
  for (const Triangles& part : parts) {
    result.push_back({part.group, part.material, selected(mesh.mesh, part.numbers)});
  }
  return result;
}

}  // namespace pyrasim
