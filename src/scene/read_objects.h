// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "json/json_reader.h"
#include "scene/scene.h"
#include "surface/reading.h"

namespace pyrasim {

/// The members "shapes" and "objects" of a scene. Throws InputError.
std::vector<Object> read_objects(const JsonReader& scene, const SceneReading& reading);

}  // namespace pyrasim
