// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "intersect/box_hierarchy.h"
#include "surface/convert.h"
#include "surface/instance.h"

namespace pyrasim {

/// A mesh in its own coordinates, once for all of its instances: a ray goes to the mesh, not the mesh to the ray.
template <class Scalar>
struct SharedMesh {
  std::vector<TriangleSurface<Scalar>> triangles;  ///< in the order of leaves; identity.order is that of the file
  std::vector<Vector<Scalar>> normals;             ///< of the same, of length 1
  std::vector<VertexNormals<Scalar>> smooth;       ///< of the same, where the surface is smooth
  std::shared_ptr<const BoxHierarchy> hierarchy;   ///< of the same; its boxes are not grown, queries are
};

/// Not yet rounded to the datapath's format. No coordinate is larger than 2^`exponent`.
SharedMesh<double> shared_mesh(const InstancedMesh& of, int exponent);

template <class Scalar>
SharedMesh<Scalar> rounded(const SharedMesh<double>& mesh) {
  const ToFormat<Scalar> round;
  SharedMesh<Scalar> result{{}, {}, {}, mesh.hierarchy};
  result.triangles.reserve(mesh.triangles.size());
  result.normals.reserve(mesh.normals.size());
  for (const auto& triangle : mesh.triangles) result.triangles.push_back(rounded<Scalar>(triangle));
  for (const auto& normal : mesh.normals) result.normals.push_back(round(normal, 0));
  for (const auto& normals : mesh.smooth) result.smooth.push_back(round(normals, 0));
  return result;
}

}  // namespace pyrasim
