// SPDX-License-Identifier: Apache-2.0
// What a scene file says, in the world's coordinates.
#pragma once

#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "camera/camera.h"
#include "shading/color.h"
#include "shading/light.h"
#include "surface/list.h"
#include "texture/object_texture.h"

namespace pyrasim {

/// The older form: one directional light without shadows, and the share that comes from everywhere. It is computed in
/// the datapath's number format; lights of a list are, in double, from the place that the datapath found.
struct SingleLight {
  double ambient = 0;              ///< share of light that arrives from everywhere, 0 to 1
  glm::dvec3 direction{0, -1, 0};  ///< the way the light travels, any length but zero
};

/// One entry of the scene: what decides case 2 against case 3 (decision D4).
struct Object {
  std::string name;  ///< may be empty
  glm::dvec3 color;  ///< linear RGB
  SceneSurface surface;
  bool casts_shadow = true;
  std::shared_ptr<const ObjectTexture> texture{};  ///< multiplies the colour; none: it is plain
};

struct Scene {
  Camera camera;
  glm::dvec3 background{0, 0, 0};  ///< linear RGB
  /// One of both, or neither: then colours are emitted as they are.
  std::optional<SingleLight> light;
  std::optional<std::vector<Light>> lights;
  std::vector<Object> objects;
  std::vector<std::string> warnings;  ///< one line each, for stderr
  std::vector<std::string> files;     ///< that it was read from: the scene's own, then its meshes'
};

}  // namespace pyrasim
