// SPDX-License-Identifier: Apache-2.0
#include "mesh/mtl_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include "error.h"
#include "numeric/length_range.h"
#include "shading/color.h"
#include "text/counted.h"
#include "text/counted_names.h"
#include "text/parse_number.h"
#include "text/printable.h"
#include "text/text_lines.h"

namespace pyrasim {
namespace {

/// Says nothing of what a diffuse surface looks like in the light that there is.
constexpr std::string_view silent[] = {"Ka",     "Ks",     "Ns",       "Ni",       "illum",    "sharpness", "map_Ka",
                                       "map_Ks", "map_Ns", "map_aat",  "Pr",       "Pm",       "Ps",        "Pc",
                                       "Pcr",    "aniso",  "anisor",   "map_Pr",   "map_Pm",   "map_Ps",    "refl",
                                       "decal",  "disp",   "map_refl", "map_disp", "map_decal"};

class MtlReader {
 public:
  explicit MtlReader(const std::string& file) : file_(file) {}

  MtlFile read(std::string_view text) {
    TextLines lines(text);
    while (lines.next()) {
      line_ = lines.number();
      read_line(lines.line());
    }
    CountedNames names;
    for (const auto& [keyword, count] : unread_) names.add(keyword, count);
    if (!names.empty()) {
      mtl_.warnings.push_back(
          fmt::format("{}: of materials Kd and map_Kd are read; these lines are passed over: {}", file_, names.text()));
    }
    return std::move(mtl_);
  }

 private:
  [[noreturn]] void fail(std::string_view wrong, std::string_view allowed) const {
    throw InputError(fmt::format("{}: {}; {}", place(), wrong, allowed));
  }
  std::string place() const { return fmt::format("{}:{}", file_, line_); }
  static std::string in_quotes(std::string_view word) { return '"' + excerpt(word) + '"'; }

  void read_line(std::string_view line) {
    const std::string_view keyword = next_word(line);
    if (keyword.empty()) return;
    if (keyword == "newmtl") {
      mtl_.materials.emplace_back().name = trimmed(line);
    } else if (keyword == "Kd") {
      material(keyword).color = read_color(line);
    } else if (keyword == "map_Kd") {
      material(keyword).map = read_map(line);
    } else if (!says_nothing(keyword, line)) {
      ++unread_[std::string(keyword)];
    }
  }

  Material& material(std::string_view keyword) {
    if (mtl_.materials.empty()) {
      fail(fmt::format("{} of no material", keyword), "newmtl and a material's name are needed before it");
    }
    return mtl_.materials.back();
  }

  /// Materials are opaque and give no light by themselves: files that say so say nothing new.
  static bool says_nothing(std::string_view keyword, std::string_view line) {
    if (std::find(std::begin(silent), std::end(silent), keyword) != std::end(silent)) return true;
    if (keyword != "d" && keyword != "Tr" && keyword != "Ke" && keyword != "Tf") return false;
    const double plain = keyword == "d" || keyword == "Tf" ? 1 : 0;
    for (std::string_view word = next_word(line); !word.empty(); word = next_word(line)) {
      double value = 0;
      if (!parse_whole(word, value) || value != plain) return false;
    }
    return true;
  }

  double read_number(std::string_view word, const NumberRange& range, std::string_view what) const {
    double value = 0;
    if (!parse_whole(word, value) || !range.contains(value)) {
      fail(fmt::format("{} is no {}", in_quotes(word), what), range.text() + " is allowed");
    }
    return value;
  }

  /// One number stands for all three.
  glm::dvec3 read_color(std::string_view line) const {
    glm::dvec3 color(0);
    for (int k = 0; k < 3; ++k) {
      const std::string_view word = next_word(line);
      if (word.empty() && k == 1) return glm::dvec3(color.x);
      if (word.empty())
        fail("a colour of " + counted(static_cast<std::uint64_t>(k), "number"), "three are needed, or one");
      if (word == "spectral" || word == "xyz")
        fail(fmt::format("a {} colour", word), "red, green and blue are allowed");
      color[k] = read_number(word, color_components, "colour");
    }
    return color;
  }

  MaterialMap read_map(std::string_view line) {
    MaterialMap map;
    map.line = place();
    std::string_view rest = line;
    for (std::string_view word = next_word(rest); word.starts_with('-'); word = next_word(rest)) {
      read_option(word, rest, map);
      line = rest;
    }
    map.file = trimmed(line);
    std::replace(map.file.begin(), map.file.end(), '\\', '/');
    if (map.file.empty() || map.file.find('\0') != std::string::npos) {
      fail("map_Kd without a file", "the path of a PNG file is allowed");
    }
    return map;
  }

  /// Leaves what follows the option in `rest`.
  void read_option(std::string_view option, std::string_view& rest, MaterialMap& map) {
    if (option == "-s" || option == "-o" || option == "-t") {
      glm::dvec2 values = option == "-s" ? glm::dvec2(1) : glm::dvec2(0);
      for (int k = 0; k < 3; ++k) {
        std::string_view behind = rest;
        double value = 0;
        const std::string_view word = next_word(behind);
        if (!parse_whole(word, value)) break;
        if (k < 2) values[k] = read_number(word, {-max_coordinate, max_coordinate}, "texture coordinate");
        rest = behind;
      }
      if (option == "-s") map.scale = values;
      if (option == "-o") map.offset = values;
      if (option == "-t") ++unread_["map_Kd -t"];
      if (std::min(std::abs(map.scale.x), std::abs(map.scale.y)) < min_length) {
        fail("a scale of nothing", fmt::format("{} at least is allowed", min_length));
      }
      return;
    }
    const std::string_view value = next_word(rest);
    if (option == "-clamp") {
      map.clamp = value == "on";
      return;
    }
    if (option == "-mm") next_word(rest);  // it has two values
    if (option != "-blendu" && option != "-blendv") ++unread_["map_Kd " + std::string(option)];
  }

  const std::string& file_;
  MtlFile mtl_;
  std::size_t line_ = 0;
  std::map<std::string, std::size_t> unread_;
};

}  // namespace

MtlFile read_mtl(std::string_view text, const std::string& file) { return MtlReader(file).read(text); }

}  // namespace pyrasim
