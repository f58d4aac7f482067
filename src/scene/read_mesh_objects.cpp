// SPDX-License-Identifier: Apache-2.0
#include "scene/read_mesh_objects.h"

#include <utility>

#include "mesh/load_materials.h"
#include "mesh/split_mesh.h"
#include "surface/mesh_file.h"
#include "text/printable.h"

namespace pyrasim {
namespace {

bool by_group(const JsonReader& object) {
  enum class Split { groups };
  return object.optional_choice<Split>("split", {{"groups", Split::groups}}).has_value();
}

void append(std::string& name, const std::string& part) {
  if (!part.empty()) name += (name.empty() ? "" : "/") + part;
}

/// The materials of an object's file.
class Materials {
 public:
  Materials(const JsonReader& file, const LoadedMesh& mesh, const SceneReading& reading, TextureReader& textures)
      : file_(file),
        reading_(reading),
        textures_(textures),
        loaded_(read_of_file(file, [&] { return load_materials(mesh, path_of_mesh(file, reading)); })) {
    reading.files.insert(reading.files.end(), loaded_.files.begin(), loaded_.files.end());
    for (const std::string& warning : loaded_.warnings) add_warning(file, reading, warning);
  }

  /// Gives the object its material, white where it has none.
  void apply(std::uint32_t material, MeshObject& object) {
    if (material == no_value) {
      add_warning(file_, reading_,
                  one_line(path_of_mesh(file_, reading_)) + ": faces before the first usemtl are white");
      return;
    }
    const Material& of = loaded_.materials[material];
    append(object.name, of.name);
    object.color = of.color;
    if (of.map) object.texture = read_of_file(file_, [&] { return textures_.read(*of.map); });
  }

 private:
  const JsonReader& file_;
  const SceneReading& reading_;
  TextureReader& textures_;
  LoadedMaterials loaded_;
};

}  // namespace

bool is_split(const JsonReader& object, const SceneReading& reading) {
  if (object.member("type").string() != Mesh::type) return false;
  if (object.has("split")) return true;
  if (object.has("color") || object.has("texture")) return false;
  return !mesh_of_file(object.member("file"), reading).materials.empty();
}

std::vector<MeshObject> read_mesh_objects(const JsonReader& object, const std::optional<glm::dvec3>& color,
                                          const SceneReading& reading, TextureReader& textures) {
  const JsonReader file = object.member("file");
  const LoadedMesh& loaded = mesh_of_file(file, reading);
  const bool grouped = by_group(object);
  warn_of_unused(file, reading, !color, grouped);
  std::optional<Materials> materials;
  if (!color) materials.emplace(file, loaded, reading, textures);
  std::vector<MeshObject> objects;
  for (MeshPart& part : split_mesh(loaded, grouped, !color)) {
    MeshObject& made = objects.emplace_back();
    if (grouped) append(made.name, loaded.groups[part.group].text);
    made.color = color.value_or(glm::dvec3(1));
    if (materials) materials->apply(part.material, made);
    made.mesh = Mesh::of(std::move(part.mesh), object);
  }
  return objects;
}

}  // namespace pyrasim
