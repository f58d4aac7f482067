// SPDX-License-Identifier: Apache-2.0
#include "shipped_scene.h"

#include "scene/load_scene.h"

namespace pyrasim {

Scene shipped_scene(const std::string& name) { return load_scene(PYRASIM_SOURCE_DIR "/scenes/" + name + ".json"); }

std::filesystem::path shipped_machine(const std::string& name) {
  return PYRASIM_SOURCE_DIR "/machines/" + name + ".json";
}

}  // namespace pyrasim
