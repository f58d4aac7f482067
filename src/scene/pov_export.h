// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "scene/scene.h"

namespace pyrasim {

/// Of an object that is shown by its number: different from black and from all others' in 8 bits a component, and far
/// from those of its neighbours in the scene.
glm::dvec3 id_color(std::size_t object);

/// `scene` in the scene description language of POV-Ray 3.7, in the world's coordinates: what it shows of a pixel is
/// what a ray through the pixel's centre shows here. With `ids` the background is black and every object has its
/// id_color(), without light. `remark`: a line in front.
std::string pov_scene(const Scene& scene, bool ids, const std::string& remark);

}  // namespace pyrasim
