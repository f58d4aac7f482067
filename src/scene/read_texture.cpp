// SPDX-License-Identifier: Apache-2.0
#include "scene/read_texture.h"

#include "image/png.h"
#include "numeric/length_range.h"
#include "shading/color.h"

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

std::shared_ptr<const ImageTexture> TextureReader::picture(const JsonReader& file, Wrap wrap) {
  const std::filesystem::path path = folder_ / file.string();
  if (path.extension() != ".png") file.fail("it is no PNG file by its name", "a file that ends in .png is allowed");
  auto& picture = pictures_[{path.string(), wrap}];
  if (picture) return picture;
  files_.push_back(path.string());
  return picture = std::make_shared<const ImageTexture>(read_png(path), wrap);
}

Texture TextureReader::read(const JsonReader& reader) {
  Texture texture;
  texture.pattern = reader.member("type").choice<Pattern>(
      {{"checker", Pattern::checker}, {"stripes", Pattern::stripes}, {"image", Pattern::image}});
  if (texture.pattern == Pattern::image) {
    reader.allow_keys({"type", "file", "wrap", "scale", "shift", "turn"});
    const auto wrap = reader.optional_choice<Wrap>("wrap", {{"repeat", Wrap::repeat}, {"clamp", Wrap::clamp}});
    texture.image = picture(reader.member("file"), wrap.value_or(Wrap::repeat));
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
