// SPDX-License-Identifier: Apache-2.0
#include "scene/read_texture.h"

#include <fmt/format.h>

#include "error.h"
#include "image/png.h"
#include "numeric/length_range.h"
#include "shading/color.h"
#include "text/printable.h"

namespace pyrasim {
namespace {

std::array<double, 2> read_pair(const JsonReader& reader, const NumberRange& range) {
  std::array<double, 2> pair{};
  std::size_t k = 0;
  for (const JsonReader& element : reader.elements(2, 2)) pair[k++] = element.number(range);
  return pair;
}

std::array<glm::dvec3, 2> read_colors(const JsonReader& reader) {
  std::array<glm::dvec3, 2> colors{};
  std::size_t k = 0;
  for (const JsonReader& color : reader.elements(2, 2)) colors[k++] = color.vec3(color_components);
  return colors;
}

}  // namespace

std::shared_ptr<const ImageTexture> TextureReader::picture(const std::filesystem::path& path, Wrap wrap) {
  if (path.extension() != ".png") return nullptr;
  auto& picture = pictures_[{path.string(), wrap}];
  if (picture) return picture;
  files_.push_back(path.string());
  return picture = std::make_shared<const ImageTexture>(read_png(path), wrap);
}

Texture TextureReader::read(const MaterialMap& map) {
  Texture texture;
  texture.pattern = Pattern::image;
  try {
    texture.image = picture(map.file, map.clamp ? Wrap::clamp : Wrap::repeat);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", map.line, error.what()));
  }
  if (!texture.image) {
    throw InputError(fmt::format("{}: {} is no PNG file by its name; a file that ends in .png is allowed", map.line,
                                 one_line(map.file)));
  }
  texture.scale = {1 / map.scale.x, 1 / map.scale.y};
  texture.shift = {-map.offset.x / map.scale.x, -map.offset.y / map.scale.y};
  return texture;
}

Texture TextureReader::read(const JsonReader& reader) {
  Texture texture;
  texture.pattern = reader.member("type").choice<Pattern>(
      {{"checker", Pattern::checker}, {"stripes", Pattern::stripes}, {"image", Pattern::image}});
  if (texture.pattern == Pattern::image) {
    reader.allow_keys({"type", "file", "wrap", "scale", "shift", "turn"});
    const auto wrap = reader.optional_choice<Wrap>("wrap", {{"repeat", Wrap::repeat}, {"clamp", Wrap::clamp}});
    const JsonReader file = reader.member("file");
    texture.image = picture(folder_ / file.string(), wrap.value_or(Wrap::repeat));
    if (!texture.image) file.fail("it is no PNG file by its name", "a file that ends in .png is allowed");
  } else {
    reader.allow_keys({"type", "colors", "scale", "shift", "turn"});
    texture.colors = read_colors(reader.member("colors"));
  }
  if (const auto scale = reader.find("scale")) texture.scale = read_pair(*scale, {min_length, max_coordinate});
  if (const auto shift = reader.find("shift")) texture.shift = read_pair(*shift, {-max_coordinate, max_coordinate});
  texture.turn = reader.optional_number("turn").value_or(0);
  return texture;
}

}  // namespace pyrasim
