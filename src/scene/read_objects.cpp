// SPDX-License-Identifier: Apache-2.0
#include "scene/read_objects.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <type_traits>
#include <utility>

#include "scene/read_transform.h"
#include "surface/transformed.h"
#include "text/printable.h"

namespace pyrasim {
namespace {

using Keys = std::vector<std::string_view>;

std::string in_quotes(const std::string& name) { return '"' + excerpt(name) + '"'; }

/// A surface as it was written, and what becomes of it; not mapped yet, so that a chain of transforms is rounded once.
struct Shape {
  std::shared_ptr<const SceneSurface> surface;
  std::optional<AffineMap> map;  ///< none where no transform is written
};

/// The shapes of a scene, by name; each is read when it is asked for first.
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
    Shape shape = chosen == nullptr ? read_instance(reader, keys)
                                    : Shape{std::make_shared<const SceneSurface>(chosen(reader, reading_, keys)), {}};
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

  Shape read_instance(const JsonReader& reader, Keys keys) {
    keys.emplace_back("of");
    reader.allow_keys(keys);
    const JsonReader of = reader.member("of");
    const auto found = written_.find(of.string());
    if (found == written_.end()) {
      of.fail(fmt::format("there is no shape {}", in_quotes(of.string())), "the name of one of \"shapes\" is allowed");
    }
    return named(found->first, of);
  }

  /// `asked`: where its name is.
  Shape named(const std::string& name, const JsonReader& asked) {
    if (const auto known = shapes_.find(name); known != shapes_.end()) return known->second;
    const auto first = std::find(open_.begin(), open_.end(), name);
    if (first != open_.end()) {
      std::string circle;
      for (auto inner = first; inner != open_.end(); ++inner) circle += in_quotes(*inner) + " of ";
      asked.fail(fmt::format("a shape is made of itself: {}{}", circle, in_quotes(name)),
                 "instances that end at a surface are allowed");
    }
    open_.push_back(name);
    Shape shape = read(written_.at(name), {"type", "transform"});
    open_.pop_back();
    shapes_.emplace(name, shape);
    return shape;
  }

  const SceneReading& reading_;
  std::map<std::string, JsonReader> written_;
  std::map<std::string, Shape> shapes_;
  std::vector<std::string> open_;  ///< those that are being read, the outermost first
};

}  // namespace

std::vector<Object> read_objects(const JsonReader& scene, const SceneReading& reading) {
  Shapes shapes(scene, reading);
  std::vector<Object> objects;
  const Keys keys{"name", "type", "color", "shadow", "transform"};
  const JsonElements elements = scene.member("objects").elements();
  objects.reserve(elements.size());
  for (const JsonReader& reader : elements) {
    const Shape shape = shapes.read(reader, keys);
    objects.push_back({reader.optional_string("name").value_or(""), reader.member("color").vec3(color_components),
                       Shapes::place(shape, reader), reader.optional_boolean("shadow").value_or(true)});
  }
  return objects;
}

}  // namespace pyrasim
