// SPDX-License-Identifier: Apache-2.0
#include "mesh/load_materials.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "error.h"
#include "json/json_file.h"
#include "text/printable.h"
#include "text/text_lines.h"

namespace pyrasim {
namespace {

constexpr std::string_view allowed = "a readable MTL file is needed, or the object's color in the scene";

/// What `mtllib` names: names with blanks in them are known by being there.
std::vector<std::string> names_of(const std::filesystem::path& folder, const std::string& names) {
  std::error_code none;
  if (names.find('\0') == std::string::npos && std::filesystem::exists(folder / names, none)) return {names};
  std::vector<std::string> result;
  std::string_view rest = names;
  for (std::string_view word = next_word(rest); !word.empty(); word = next_word(rest)) result.emplace_back(word);
  return result;
}

class MaterialLoader {
 public:
  explicit MaterialLoader(const std::filesystem::path& mesh)
      : mesh_(one_line(mesh.string())), folder_(mesh.parent_path()) {}

  void read_library(const ObjFile::Name& library) {
    for (const std::string& name : names_of(folder_, library.text)) read_library(folder_ / name, library.line);
  }

  LoadedMaterials named(const std::vector<ObjFile::Name>& names) {
    for (const auto& [name, line] : names) {
      const auto found = known_.find(name);
      if (found == known_.end()) {
        throw InputError(fmt::format("{}:{}: none of its libraries has a material \"{}\"; {}", mesh_, line,
                                     excerpt(name), "one of theirs is allowed, or the object's color in the scene"));
      }
      loaded_.materials.push_back(found->second);
    }
    return std::move(loaded_);
  }

 private:
  void read_library(const std::filesystem::path& path, std::size_t line) {
    if (std::find(loaded_.files.begin(), loaded_.files.end(), path.string()) != loaded_.files.end()) return;
    const std::string name = one_line(path.string());
    MtlFile mtl = read_mtl(text_of(path, name, line), name);
    loaded_.files.push_back(path.string());
    for (std::string& warning : mtl.warnings) loaded_.warnings.push_back(std::move(warning));
    for (Material& material : mtl.materials) {
      if (material.map) material.map->file = (path.parent_path() / material.map->file).string();
      known_.emplace(material.name, std::move(material));
    }
  }

  /// A library is somebody else's file, which may name anything: of what is no file nothing is read.
  std::string text_of(const std::filesystem::path& path, const std::string& name, std::size_t line) const {
    std::string reason = "it is no file";
    std::error_code none;
    const bool other = std::filesystem::exists(path, none) && !std::filesystem::is_regular_file(path, none);
    if (!other && path.native().find('\0') == std::string::npos) {
      try {
        return read_text(path);
      } catch (const std::runtime_error& error) {
        reason = error.what();
      }
    }
    throw InputError(fmt::format("{}:{}: {} cannot be read: {}; {}", mesh_, line, name, reason, allowed));
  }

  std::string mesh_;
  std::filesystem::path folder_;
  std::map<std::string, Material> known_;
  LoadedMaterials loaded_;
};

}  // namespace

LoadedMaterials load_materials(const LoadedMesh& mesh, const std::filesystem::path& file) {
  MaterialLoader loader(file);
  for (const ObjFile::Name& library : mesh.libraries) loader.read_library(library);
  return loader.named(mesh.materials);
}

}  // namespace pyrasim
