// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "json/json_reader.h"
#include "mesh/mtl_file.h"
#include "texture/texture.h"

namespace pyrasim {

/// Reads the textures of a scene; each picture once.
class TextureReader {
 public:
  /// Files are looked for in `folder`, and added to `files`.
  TextureReader(std::filesystem::path folder, std::vector<std::string>& files)
      : folder_(std::move(folder)), files_(files) {}

  /// Throws InputError.
  Texture read(const JsonReader& reader);
  /// That of a mesh's material. Throws InputError, too, with the line that names it.
  Texture read(const MaterialMap& map);

 private:
  /// Nothing where the file is no PNG by its name.
  std::shared_ptr<const ImageTexture> picture(const std::filesystem::path& path, Wrap wrap);

  std::filesystem::path folder_;
  std::vector<std::string>& files_;
  std::map<std::pair<std::string, Wrap>, std::shared_ptr<const ImageTexture>> pictures_;
};

}  // namespace pyrasim
