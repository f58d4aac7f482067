// SPDX-License-Identifier: Apache-2.0
#include "intersect/shared_mesh.h"

#include "camera/observer_frame.h"

namespace pyrasim {

SharedMesh<double> shared_mesh(const InstancedMesh& of, int exponent) {
  const double unit = std::ldexp(1.0, exponent);
  const auto& triangles = of.mesh.triangles;
  const auto corners = [&](std::uint32_t number) {
    const auto& [a, b, c] = triangles[number];
    return std::array{of.vertex(a) * unit, of.vertex(b) * unit, of.vertex(c) * unit};
  };
  std::vector<BoundingBox> boxes;
  boxes.reserve(triangles.size());
  for (std::uint32_t k = 0; k < triangles.size(); ++k) boxes.push_back(box_of(corners(k)));
  SharedMesh<double> shared{{}, {}, {}, std::make_shared<const BoxHierarchy>(boxes)};
  shared.triangles.reserve(triangles.size());
  shared.normals.reserve(triangles.size());
  for (const std::uint32_t number : shared.hierarchy->items()) {
    const auto [a, b, c] = corners(number);
    shared.triangles.push_back({{{{a.x, a.y, a.z}, {b.x, b.y, b.z}, {c.x, c.y, c.z}}}, {0, number}});
    shared.normals.push_back(normalized(cross(normalized(b - a), normalized(c - a))));
    if (!of.mesh.normals.empty()) shared.smooth.push_back(of.mesh.normals.of(number));
  }
  return shared;
}

}  // namespace pyrasim
