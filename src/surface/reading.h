// SPDX-License-Identifier: Apache-2.0
// What reading a surface from a scene file takes.
#pragma once

#include <filesystem>
#include <glm/vec3.hpp>
#include <map>
#include <string>
#include <vector>

#include "json/json_reader.h"
#include "mesh/load_mesh.h"
#include "numeric/length_range.h"

namespace pyrasim {

inline constexpr NumberRange coordinates{-max_coordinate, max_coordinate};
inline constexpr NumberRange lengths{min_length, max_coordinate};

/// A vector whose length does not matter, as long as there is one. Throws InputError.
glm::dvec3 read_direction(const JsonReader& reader);

/// What the objects of one scene are read with.
struct SceneReading {
  std::filesystem::path folder;               ///< where the paths of files begin
  std::vector<std::string>& warnings;         ///< one line each
  std::vector<std::string>& files;            ///< that the scene was read from
  std::map<std::string, LoadedMesh>& meshes;  ///< by path: each file is read once
};

}  // namespace pyrasim
