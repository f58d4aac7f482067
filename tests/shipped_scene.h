// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "scene/scene.h"

namespace pyrasim {

/// One of the project's scenes/, by its name without the ending.
Scene shipped_scene(const std::string& name);

/// One of the project's machines/, likewise.
std::filesystem::path shipped_machine(const std::string& name);

}  // namespace pyrasim
