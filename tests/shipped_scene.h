// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "scene/scene.h"

namespace pyrasim {

/// One of the project's scenes/, by its name without the ending.
Scene shipped_scene(const std::string& name);

}  // namespace pyrasim
