// SPDX-License-Identifier: Apache-2.0
#include "surface/mesh_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "text/printable.h"

namespace pyrasim {

std::string path_of_mesh(const JsonReader& reader, const SceneReading& reading) {
  const std::string name = reader.string();
  if (name.empty() || name.find('\0') != std::string::npos) {
    reader.fail("the path is empty or holds a null character", "the path of an OBJ file is allowed");
  }
  return (reading.folder / name).string();
}

const LoadedMesh& mesh_of_file(const JsonReader& reader, const SceneReading& reading) {
  const std::string path = path_of_mesh(reader, reading);
  if (const auto known = reading.meshes.find(path); known != reading.meshes.end()) return known->second;
  LoadedMesh mesh = read_of_file(reader, [&] { return load_mesh(path); });
  const LoadedMesh& loaded = reading.meshes.emplace(path, std::move(mesh)).first->second;
  reading.files.push_back(path);
  for (const std::string& warning : loaded.warnings) add_warning(reader, reading, warning);
  return loaded;
}

void add_warning(const JsonReader& reader, const SceneReading& reading, const std::string& warning) {
  auto& warnings = reading.warnings;
  const bool said = std::any_of(warnings.begin(), warnings.end(),
                                [&](const std::string& other) { return other.ends_with(": " + warning); });
  if (!said) warnings.push_back(fmt::format("{}: {}: {}", reader.file(), reader.pointer(), warning));
}

void warn_of_unused(const JsonReader& reader, const SceneReading& reading, bool materials_used, bool groups_used) {
  const std::string path = path_of_mesh(reader, reading);
  const LoadedMesh& mesh = mesh_of_file(reader, reading);
  for (const std::string& warning : mesh.unused(one_line(path), materials_used, groups_used)) {
    add_warning(reader, reading, warning);
  }
}

}  // namespace pyrasim
