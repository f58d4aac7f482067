// SPDX-License-Identifier: Apache-2.0
// The OBJ file that a scene's mesh is of.
#pragma once

#include <fmt/format.h>

#include <string>

#include "error.h"
#include "surface/reading.h"

namespace pyrasim {

/// f(), whose InputErrors are told where the scene names the file that they are about.
template <class F>
auto read_of_file(const JsonReader& reader, const F& f) {
  try {
    return f();
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}: {}", reader.file(), reader.pointer(), error.what()));
  }
}

/// Where the mesh's file is; `reader` is of the member "file". Throws InputError.
std::string path_of_mesh(const JsonReader& reader, const SceneReading& reading);

/// What is in it; it is read once for a scene. Throws InputError, with where the scene names it.
const LoadedMesh& mesh_of_file(const JsonReader& reader, const SceneReading& reading);

/// Says once of a file what of it an object leaves unused.
void warn_of_unused(const JsonReader& reader, const SceneReading& reading, bool materials_used, bool groups_used);

/// Adds a warning that is not there yet, with where the scene names the file that it is about.
void add_warning(const JsonReader& reader, const SceneReading& reading, const std::string& warning);

}  // namespace pyrasim
