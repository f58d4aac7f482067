// SPDX-License-Identifier: Apache-2.0
#include "scene/read_texture.h"

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

}  // namespace

Texture read_texture(const JsonReader& reader) {
  reader.allow_keys({"type", "colors", "scale", "shift", "turn"});
  Texture texture;
  texture.pattern =
      reader.member("type").choice<Pattern>({{"checker", Pattern::checker}, {"stripes", Pattern::stripes}});
  std::size_t k = 0;
  for (const JsonReader& color : reader.member("colors").elements(2, 2)) {
    texture.colors[k++] = color.vec3(color_components);
  }
  if (const auto scale = reader.find("scale")) texture.scale = read_pair(*scale, {min_length, max_coordinate});
  if (const auto shift = reader.find("shift")) texture.shift = read_pair(*shift, {-max_coordinate, max_coordinate});
  texture.turn = reader.optional_number("turn").value_or(0);
  return texture;
}

}  // namespace pyrasim
