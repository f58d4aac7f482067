// SPDX-License-Identifier: Apache-2.0
// A prepared scene rounded to the number format that traces it.
#pragma once

#include <type_traits>

#include "intersect/prepared_scene.h"

namespace pyrasim {

template <class Scalar>
Vector<Scalar> rounded(const Vector<double>& v) {
  return to_scalar<Scalar>(v);
}

template <class Scalar>
SphereSurface<Scalar> rounded(const SphereSurface<double>& sphere) {
  return {rounded<Scalar>(sphere.center), static_cast<Scalar>(sphere.radius_squared), static_cast<Scalar>(sphere.power),
          static_cast<Scalar>(sphere.radius), sphere.identity};
}

template <class Scalar>
FlatShading<Scalar> rounded(const FlatShading<double>& shading) {
  return {rounded<Scalar>(shading.normal), static_cast<Scalar>(shading.front), static_cast<Scalar>(shading.back)};
}

template <class Scalar>
PlaneSurface<Scalar> rounded(const PlaneSurface<double>& plane) {
  return {static_cast<Scalar>(plane.offset), plane.identity, rounded<Scalar>(plane.shading), plane.relative_error,
          plane.squared_length};
}

template <class Scalar>
TriangleSurface<Scalar> rounded(const TriangleSurface<double>& triangle) {
  TriangleSurface<Scalar> result{{}, triangle.identity};
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      result.vertices[k][axis] = static_cast<Scalar>(triangle.vertices[k][axis]);
    }
  }
  return result;
}

/// What distance_range() asks of a surface, exactly.
template <class Scalar>
Vector<double> in_double(const Vector<Scalar>& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

template <class Scalar>
SphereSurface<double> in_double(const SphereSurface<Scalar>& sphere) {
  return {in_double(sphere.center), static_cast<double>(sphere.radius_squared), static_cast<double>(sphere.power),
          static_cast<double>(sphere.radius), sphere.identity};
}

template <class Scalar>
PlaneSurface<double> in_double(const PlaneSurface<Scalar>& plane) {
  return {static_cast<double>(plane.offset), plane.identity, {in_double(plane.shading.normal), 0, 0}, 0, 0};
}

template <class Scalar>
TriangleSurface<double> in_double(const TriangleSurface<Scalar>& triangle) {
  TriangleSurface<double> result{{}, triangle.identity};
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      result.vertices[k][axis] = static_cast<double>(triangle.vertices[k][axis]);
    }
  }
  return result;
}

template <class Scalar>
SlopeBoxes<Scalar> rounded(const SlopeBoxes<double>& boxes) {
  SlopeBoxes<Scalar> result;
  for (std::size_t k = 0; k < node_width; ++k) {
    result.depth[k] = static_cast<Scalar>(boxes.depth[k]);
    result.lower_y[k] = static_cast<Scalar>(boxes.lower_y[k]);
    result.upper_y[k] = static_cast<Scalar>(boxes.upper_y[k]);
    result.lower_z[k] = static_cast<Scalar>(boxes.lower_z[k]);
    result.upper_z[k] = static_cast<Scalar>(boxes.upper_z[k]);
  }
  return result;
}

/// Every number rounded to the nearest value of `Scalar`. The bounds of the hierarchy hold in `Scalar` where the scene
/// was prepared for its format.
template <class Scalar>
PreparedScene<Scalar> rounded(PreparedScene<double> scene) {
  if constexpr (std::is_same_v<Scalar, double>) {
    return scene;
  } else {
    PreparedScene<Scalar> result;
    for (const auto& node : scene.nodes) {
      result.nodes.push_back({rounded<Scalar>(node.boxes), node.child, node.children});
    }
    for (const auto& leaf : scene.leaves) {
      result.leaves.push_back(
          {leaf.first_sphere, leaf.spheres, leaf.first_triangle, leaf.triangles, leaf.relative_error});
    }
    result.root = scene.root;
    result.everything = scene.everything;
    for (const auto& sphere : scene.spheres) result.spheres.push_back(rounded<Scalar>(sphere));
    for (const auto& triangle : scene.triangles) result.triangles.push_back(rounded<Scalar>(triangle));
    for (const auto& shading : scene.triangle_shading) result.triangle_shading.push_back(rounded<Scalar>(shading));
    for (const auto& plane : scene.planes) result.planes.push_back(rounded<Scalar>(plane));
    result.lit = scene.lit;
    result.ambient = static_cast<Scalar>(scene.ambient);
    result.towards_light = rounded<Scalar>(scene.towards_light);
    result.exponent = scene.exponent;
    result.rounding = scene.rounding;
    return result;
  }
}

}  // namespace pyrasim
