// SPDX-License-Identifier: Apache-2.0
// Where a ray meets a surface of a decimal scene, exactly.
#pragma once

#include <optional>

#include "decimal_scene.h"
#include "scene/scene.h"

namespace pyrasim {

/// A ray in the world's coordinates.
struct WorldRay {
  RealVector origin;
  RealVector direction;

  /// Along a view vector, turned by the axes that the camera's doubles stand for.
  WorldRay(const Camera& camera, const glm::dvec3& view_vector);
};

/// The ray's parameter at the nearest hit ahead; none where the ray misses.
std::optional<Real> exact_distance(const SceneSurface& surface, const WorldRay& ray);

}  // namespace pyrasim
