// SPDX-License-Identifier: Apache-2.0
#include "scene/read_objects.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <type_traits>
#include <utility>

#include "scene/read_mesh_objects.h"
#include "scene/read_texture.h"
#include "scene/read_transform.h"
#include "surface/transformed.h"
#include "text/printable.h"

namespace pyrasim {
namespace {

using Keys = std::vector<std::string_view>;

/// Of a shape, beside those of its surface or instance.
Keys shape_keys() { return {"type", "transform"}; }

std::string in_quotes(const std::string& name) { return '"' + excerpt(name) + '"'; }

/// A surface as it was written, and what becomes of it; not mapped yet, so that a chain of transforms is rounded once.
struct Shape {
  std::shared_ptr<const SceneSurface> surface;
  std::optional<AffineMap> map;  ///< none where no transform is written
};

/// Surfaces that the datapath tells apart, those of instances too, have numbers of 32 bits.
class SurfaceNumbers {
 public:
  void count(const SceneSurface& surface, const JsonReader& object) {
    std::uint64_t surfaces = 1;
    if (const auto* mesh = std::get_if<Mesh>(&surface)) surfaces = mesh->triangles.size();
    if (const auto* instance = std::get_if<MeshInstance>(&surface)) surfaces = instance->of->mesh.triangles.size();
    count_ += surfaces;
    if (count_ > most) {
      object.fail(fmt::format("it brings the scene to {} surfaces, triangles of instances included", count_),
                  fmt::format("{} are allowed", most));
    }
  }

 private:
  static constexpr std::uint64_t most = 0xFFFFFFFF;
  std::uint64_t count_ = 0;
};

/// The shapes of a scene, by name; each is read when it is asked for first. Instances of a mesh share it.
class Shapes {
 public:
  Shapes(const JsonReader& scene, const SceneReading& reading) : reading_(reading) {
    const auto shapes = scene.find("shapes");
    if (!shapes) return;
    for (auto& [name, reader] : shapes->members()) written_.emplace(std::move(name), std::move(reader));
    for (const auto& [name, reader] : written_) place(named(name, reader), reader);
  }

  /// A surface of any type, or an instance, with its own keys beside `keys`.
  Shape read(const JsonReader& reader, const Keys& keys) {
    const Read chosen = reader_of(reader.member("type"), std::type_identity<WrittenSurface>());
    Shape shape;
    if (chosen == nullptr) {
      const JsonReader of = read_instance(reader, keys);
      shape = named(of.string(), of);
    } else {
      shape.surface = std::make_shared<const SceneSurface>(chosen(reader, reading_, keys));
    }
    return moved(std::move(shape), reader);
  }

  /// By the transform that is written in `reader`, if there is one.
  static Shape moved(Shape shape, const JsonReader& reader) {
    if (const auto transform = reader.find("transform")) {
      const AffineMap outer = read_transform(*transform);
      shape.map = mapped_at(*transform, [&] { return shape.map ? outer.after(*shape.map) : outer; });
    }
    return shape;
  }

  /// The surface where its transforms put it.
  static SceneSurface place(const Shape& shape, const JsonReader& reader) {
    if (!shape.map) return *shape.surface;
    return mapped_at(reader.find("transform").value_or(reader),
                     [&] { return transformed(*shape.surface, *shape.map); });
  }

 private:
  using Read = SceneSurface (*)(const JsonReader&, const SceneReading&, Keys);

  /// None of an instance.
  template <class... Description>
  static Read reader_of(const JsonReader& type, std::type_identity<std::variant<Description...>>) {
    return type.choice<Read>({{Description::type,
                               [](const JsonReader& object, const SceneReading& with, Keys allowed) {
                                 allowed.insert(allowed.end(), Description::keys.begin(), Description::keys.end());
                                 object.allow_keys(allowed);
                                 return SceneSurface(Description::read(object, with));
                               }}...,
                              {"instance", nullptr}});
  }

  static bool is_instance(const JsonReader& shape) {
    return reader_of(shape.member("type"), std::type_identity<WrittenSurface>()) == nullptr;
  }

  /// Where an instance says what it is of: the name of one of the shapes.
  JsonReader read_instance(const JsonReader& reader, Keys keys) const {
    keys.emplace_back("of");
    reader.allow_keys(keys);
    JsonReader of = reader.member("of");
    if (!written_.contains(of.string())) {
      of.fail(fmt::format("there is no shape {}", in_quotes(of.string())), "the name of one of \"shapes\" is allowed");
    }
    return of;
  }

  /// `asked`: where its name is.
  const Shape& named(const std::string& name, const JsonReader& asked) {
    for (const std::string& unread : unread_before(name, asked)) {
      shapes_.emplace(unread, shareable(read(written_.at(unread), shape_keys())));
    }
    return shapes_.at(name);
  }

  /// A mesh that has a name is there once, for all of its instances.
  static Shape shareable(Shape shape) {
    if (const auto* mesh = std::get_if<Mesh>(shape.surface.get())) {
      shape.surface =
          std::make_shared<const SceneSurface>(MeshInstance{std::make_shared<const InstancedMesh>(*mesh), {}});
    }
    return shape;
  }

  /// The chain of instances that has to be read for a shape, the innermost first; instances may be nested deeper than
  /// calls.
  std::vector<std::string> unread_before(std::string name, JsonReader asked) const {
    std::vector<std::string> chain;
    std::set<std::string> met;
    while (!shapes_.contains(name)) {
      if (!met.insert(name).second) fail_circle(chain, name, asked);
      chain.push_back(name);
      if (!is_instance(written_.at(name))) break;
      asked = read_instance(written_.at(name), shape_keys());
      name = asked.string();
    }
    std::reverse(chain.begin(), chain.end());
    return chain;
  }

  [[noreturn]] static void fail_circle(const std::vector<std::string>& chain, const std::string& name,
                                       const JsonReader& asked) {
    std::string circle;
    for (auto inner = std::find(chain.begin(), chain.end(), name); inner != chain.end(); ++inner) {
      circle += in_quotes(*inner) + " of ";
    }
    asked.fail(fmt::format("a shape is made of itself: {}{}", circle, in_quotes(name)),
               "instances that end at a surface are allowed");
  }

  const SceneReading& reading_;
  std::map<std::string, JsonReader> written_;
  std::map<std::string, Shape> shapes_;
};

/// A texture on a surface as it was written; on a mesh where it is placed, since triangles may get lost on the way.
/// `reader`: what to blame. Throws InputError.
std::shared_ptr<const ObjectTexture> textured(const Shape& shape, const SceneSurface& placed, Texture texture,
                                              const JsonReader& reader) {
  const auto* mesh = std::get_if<Mesh>(&placed);
  const auto* instance = std::get_if<MeshInstance>(&placed);
  const TriangleMesh* triangles = mesh != nullptr ? mesh : instance != nullptr ? &instance->of->mesh : nullptr;
  if (triangles != nullptr && !all_have(triangles->places)) {
    reader.fail("some faces of the mesh have no texture coordinates (vt) at their corners",
                "faces that all have them may have textures");
  }
  if (mesh != nullptr) {
    return std::make_shared<const ObjectTexture>(
        ObjectTexture{std::move(texture), std::make_shared<const SceneSurface>(placed), AffineMap()});
  }
  return std::make_shared<const ObjectTexture>(
      ObjectTexture{std::move(texture), shape.surface, shape.map.value_or(AffineMap())});
}

/// Reads the objects of a scene one after the other.
class ObjectReader {
 public:
  ObjectReader(const JsonReader& scene, const SceneReading& reading)
      : reading_(reading), shapes_(scene, reading), textures_(reading.folder, reading.files) {}

  void read(const JsonReader& reader) {
    if (is_split(reader, reading_)) {
      read_parts(reader);
      return;
    }
    const Shape shape = shapes_.read(reader, object_keys());
    const auto texture = reader.find("texture");
    const glm::dvec3 color = texture ? reader.optional_vec3("color", color_components).value_or(glm::dvec3(1))
                                     : reader.member("color").vec3(color_components);
    add(reader, reader.optional_string("name").value_or(""), color, shape);
    if (texture) lay_on(shape, textures_.read(*texture), *texture);
  }

  /// Textures have meshes of their own, so that objects need no texture coordinates.
  std::vector<Object> objects() {
    for (Object& object : objects_) {
      if (auto* mesh = std::get_if<Mesh>(&object.surface)) mesh->places = {};
    }
    return std::move(objects_);
  }

 private:
  static Keys object_keys() { return {"name", "type", "color", "shadow", "transform", "texture"}; }

  /// Those of a mesh. They have the object's colour and texture, or their materials'.
  void read_parts(const JsonReader& reader) {
    Keys keys = object_keys();
    keys.insert(keys.end(), Mesh::keys.begin(), Mesh::keys.end());
    reader.allow_keys(keys);
    const auto texture = reader.find("texture");
    std::optional<glm::dvec3> color = reader.optional_vec3("color", color_components);
    if (texture && !color) color = glm::dvec3(1);
    const std::string name = reader.optional_string("name").value_or("");
    for (MeshObject& part : read_mesh_objects(reader, color, reading_, textures_)) {
      const Shape shape =
          Shapes::moved({std::make_shared<const SceneSurface>(std::move(part.mesh)), std::nullopt}, reader);
      add(reader, name.empty() || part.name.empty() ? name + part.name : name + "/" + part.name, part.color, shape);
      if (texture) part.texture = textures_.read(*texture);
      if (part.texture) lay_on(shape, std::move(*part.texture), texture.value_or(reader));
    }
  }

  void add(const JsonReader& reader, std::string name, const glm::dvec3& color, const Shape& shape) {
    objects_.push_back(
        {std::move(name), color, Shapes::place(shape, reader), reader.optional_boolean("shadow").value_or(true)});
    numbers_.count(objects_.back().surface, reader);
  }

  /// On the object that was added last.
  void lay_on(const Shape& shape, Texture texture, const JsonReader& reader) {
    objects_.back().texture = textured(shape, objects_.back().surface, std::move(texture), reader);
  }

  const SceneReading& reading_;
  Shapes shapes_;
  TextureReader textures_;
  SurfaceNumbers numbers_;
  std::vector<Object> objects_;
};

}  // namespace

std::vector<Object> read_objects(const JsonReader& scene, const SceneReading& reading) {
  ObjectReader objects(scene, reading);
  for (const JsonReader& object : scene.member("objects").elements()) objects.read(object);
  return objects.objects();
}

}  // namespace pyrasim
