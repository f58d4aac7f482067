// SPDX-License-Identifier: Apache-2.0
#include "mesh/obj_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "error.h"
#include "mesh/obj_unread.h"
#include "numeric/length_range.h"
#include "text/counted.h"
#include "text/parse_number.h"
#include "text/printable.h"
#include "text/text_lines.h"

namespace pyrasim {
namespace {

/// One of the lists that corners select from.
struct Selected {
  std::string_view what;  ///< one of them
  std::string_view all;
  long long largest = 0;  ///< index that was asked for
  std::size_t line = 0;   ///< that asked for it first
};

/// Names by the order in which they came up.
class Names {
 public:
  explicit Names(std::vector<ObjFile::Name>& names) : names_(names) {}

  std::uint32_t number_of(const std::string& name, std::size_t line) {
    const auto [known, is_new] = numbers_.emplace(name, static_cast<std::uint32_t>(names_.size()));
    if (is_new) names_.push_back({name, line});
    return known->second;
  }

 private:
  std::vector<ObjFile::Name>& names_;
  std::map<std::string, std::uint32_t> numbers_;
};

class ObjReader {
 public:
  explicit ObjReader(const std::string& file) : file_(file) { group_ = groups_.number_of("", 0); }

  ObjFile read(std::string_view text) {
    if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff")) fail(1, "it is UTF-16", "UTF-8 is allowed");
    TextLines lines(text);
    while (lines.next()) {
      line_ = lines.number();
      read_line(lines.line());
    }
    // A face may come before what it selects, so this is known only now.
    for (std::size_t k = 0; k < selected_.size(); ++k) {
      if (selected_[k].largest > count_of(k)) fail_index(k, selected_[k].largest, selected_[k].line);
    }
    obj_.warnings = unread_.warnings();
    return std::move(obj_);
  }

 private:
  [[noreturn]] void fail(std::size_t line, std::string_view wrong, std::string_view allowed) const {
    throw InputError(fmt::format("{}:{}: {}; {}", file_, line, wrong, allowed));
  }

  [[noreturn]] void fail_index(std::size_t list, long long index, std::size_t line) const {
    const long long count = count_of(list);
    fail(line, fmt::format("the index {} selects no {}", index, selected_[list].what),
         count == 0 ? fmt::format("there are no {} to select", selected_[list].all)
                    : fmt::format("1 to {}, or -1 to -{} counted back from the last, is allowed", count, count));
  }

  static std::string in_quotes(std::string_view word) { return '"' + excerpt(word) + '"'; }

  long long count_of(std::size_t list) const {
    const std::array counts{obj_.vertices.size(), obj_.places.size(), obj_.normals.size()};
    return static_cast<long long>(counts[list]);
  }

  void read_line(std::string_view line) {
    const std::string_view keyword = next_word(line);
    if (keyword.empty()) return;
    if (keyword == "v") {
      obj_.vertices.push_back(read_vector<glm::dvec3>(line, 3, "vertex", "coordinate"));
      std::size_t more = 0;
      while (!next_word(line).empty()) ++more;
      if (more >= 3) unread_.count_vertex_color();
    } else if (keyword == "vt") {
      obj_.places.push_back(read_vector<glm::dvec2>(line, 1, "texture coordinate", "coordinate"));
    } else if (keyword == "vn") {
      obj_.normals.push_back(read_vector<glm::dvec3>(line, 3, "normal", "component"));
    } else if (keyword == "f") {
      read_face(line);
    } else if (!read_name(keyword, line)) {
      unread_.count(keyword);
    }
  }

  /// Of `least` numbers or more; those that are not there are 0.
  template <class Numbers>
  Numbers read_vector(std::string_view& line, int least, std::string_view what, std::string_view part) const {
    Numbers numbers(0);
    for (int i = 0; i < Numbers::length(); ++i) {
      const std::string_view word = next_word(line);
      if (word.empty() && i >= least) break;
      if (word.empty()) {
        fail(line_, fmt::format("a {} with {} {}s", what, i, part),
             least == 1 ? "one is needed, or two" : "three are needed");
      }
      if (!parse_whole(word, numbers[i]) || !(std::abs(numbers[i]) <= max_coordinate)) {
        fail(line_, fmt::format("{} is no {}", in_quotes(word), part),
             fmt::format("a number from {} to {} is allowed", -max_coordinate, max_coordinate));
      }
    }
    return numbers;
  }

  bool read_name(std::string_view keyword, std::string_view line) {
    const std::string name(trimmed(line));
    if (keyword == "usemtl") {
      material_ = materials_.number_of(name, line_);
    } else if (keyword == "mtllib") {
      obj_.libraries.push_back({name, line_});
    } else if (keyword == "o") {
      object_ = name;
      begin_group("");
    } else if (keyword == "g") {
      begin_group(name);
    } else {
      return false;
    }
    return true;
  }

  void begin_group(const std::string& name) {
    group_ = groups_.number_of(object_.empty() || name.empty() ? object_ + name : object_ + "/" + name, line_);
  }

  void read_face(std::string_view line) {
    std::uint32_t corners = 0;
    for (std::string_view word = next_word(line); !word.empty(); word = next_word(line)) {
      obj_.corners.push_back(read_corner(word));
      ++corners;
    }
    if (corners < 3) fail(line_, "a face with " + counted(corners, "corner"), "at least 3 are needed");
    obj_.faces.push_back({line_, corners, group_, material_});
  }

  /// A corner is V, V/T, V//N or V/T/N: indices of a vertex, a texture coordinate and a normal; the slashes of absent
  /// ones may be there.
  ObjFile::Corner read_corner(std::string_view corner) {
    std::array<std::uint32_t, 3> indices{no_value, no_value, no_value};
    std::string_view rest = corner;
    for (std::size_t part = 0; part < indices.size(); ++part) {
      const std::string_view word = rest.substr(0, rest.find('/'));
      const bool last = word.size() == rest.size();
      const bool may_be_empty = part > 0;
      int index = 0;
      if (!(word.empty() && may_be_empty) && !parse_whole(word, index)) break;
      if (part > 0 && !word.empty() && index == 0) break;
      if (!word.empty()) indices[part] = selected(part, index);
      if (last) return {indices[0], indices[1], indices[2]};
      rest.remove_prefix(word.size() + 1);
    }
    fail(line_, in_quotes(corner) + " is no corner of a face",
         "V, V/T, V//N or V/T/N with indices other than 0 is allowed");
  }

  std::uint32_t selected(std::size_t list, long long index) {
    if (index == 0 || index < -count_of(list)) fail_index(list, index, line_);
    if (index < 0) return static_cast<std::uint32_t>(count_of(list) + index);
    if (index > selected_[list].largest) {
      selected_[list].largest = index;
      selected_[list].line = line_;
    }
    return static_cast<std::uint32_t>(index - 1);
  }

  const std::string& file_;
  ObjFile obj_;
  ObjUnread unread_;
  std::size_t line_ = 0;
  std::array<Selected, 3> selected_{
      {{"vertex", "vertices"}, {"texture coordinate", "texture coordinates"}, {"normal", "normals"}}};
  Names groups_{obj_.groups};
  Names materials_{obj_.materials};
  std::string object_;  ///< the name of the last `o`
  std::uint32_t group_ = 0;
  std::uint32_t material_ = no_value;
};

}  // namespace

ObjFile read_obj(std::string_view text, const std::string& file) { return ObjReader(file).read(text); }

}  // namespace pyrasim
