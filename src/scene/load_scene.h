// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "scene/scene.h"

namespace pyrasim {

/// Reads and validates a scene file (JSON, `//` comments allowed) and the meshes that it names.
/// A mesh's path is taken relative to the scene's folder. Throws InputError naming file, JSON pointer and what is
/// allowed.
Scene load_scene(const std::filesystem::path& file);

}  // namespace pyrasim
