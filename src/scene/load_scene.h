// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

#include "scene/scene.h"

namespace pyrasim {

/// Reads and validates a scene file: NFF (nff_scene.h), or JSON, `//` comments allowed, and the meshes that it names.
/// A mesh's path is taken relative to the scene's folder, that of a scene from a pipe (`/dev/stdin`, `/dev/fd/N`)
/// relative to the current one. Throws InputError naming file, JSON pointer or line, and what is allowed.
Scene load_scene(const std::filesystem::path& file);

/// The same for the JSON document that `file` holds, where it has been read already.
Scene read_scene(const std::filesystem::path& file, const nlohmann::json& document);

}  // namespace pyrasim
