// SPDX-License-Identifier: Apache-2.0
// A prepared scene rounded to the number format that traces it.
#pragma once

#include <type_traits>

#include "intersect/prepared_scene.h"
#include "surface/convert.h"

namespace pyrasim {

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

/// Every number rounded to the nearest value of `Scalar` in the format set. The bounds of the hierarchy hold in
/// `Scalar` where the scene was prepared for its format.
template <class Scalar>
PreparedScene<Scalar> rounded(PreparedScene<double> scene) {
  if constexpr (std::is_same_v<Scalar, double>) {
    return scene;
  } else {
    PreparedScene<Scalar> result;
    for (const auto& node : scene.nodes) {
      result.nodes.push_back({rounded<Scalar>(node.boxes), node.child, node.children});
    }
    result.runs = scene.runs;
    result.root = scene.root;
    result.everything = scene.everything;
    result.apart = scene.apart;
    for_each_kind([&](auto kind) {
      const auto round_all = [](const auto& from, auto& to) {
        for (const auto& value : from) to.push_back(rounded<Scalar>(value));
      };
      const auto& from = std::get<kind>(scene.kinds);
      round_all(from.surfaces, std::get<kind>(result.kinds).surfaces);
      round_all(from.shading, std::get<kind>(result.kinds).shading);
    });
    for (const SharedMesh<double>& mesh : scene.meshes) result.meshes.push_back(rounded<Scalar>(mesh));
    const ToFormat<Scalar> round;
    result.lighting = {scene.lighting.lit, round(scene.lighting.ambient, 0), round(scene.lighting.towards_light, 0)};
    result.exponent = scene.exponent;
    result.rounding = scene.rounding;
    return result;
  }
}

}  // namespace pyrasim
