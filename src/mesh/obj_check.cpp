// SPDX-License-Identifier: Apache-2.0
#include "mesh/obj_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "error.h"
#include "mesh/obj_unread.h"
#include "numeric/length_range.h"
#include "text/parse_number.h"
#include "text/printable.h"
#include "text/text_lines.h"

namespace pyrasim {
namespace {

class ObjChecker {
 public:
  explicit ObjChecker(const std::string& file) : file_(file) {}

  ObjOutline check(std::string_view text) {
    if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff")) fail(1, "it is UTF-16", "UTF-8 is allowed");
    outline_.plain.reserve(text.size());
    TextLines lines(text);
    while (lines.next()) {
      line_ = lines.number();
      check_line(lines.line());
    }
    // A face may come before its vertices, so this is known only now.
    const auto count = static_cast<long long>(outline_.vertices.size());
    if (largest_index_ > count) fail_index(largest_index_, largest_index_line_, count);
    outline_.warnings = unread_.warnings();
    return std::move(outline_);
  }

 private:
  [[noreturn]] void fail(std::size_t line, std::string_view wrong, std::string_view allowed) const {
    throw InputError(fmt::format("{}:{}: {}; {}", file_, line, wrong, allowed));
  }

  [[noreturn]] void fail_index(long long index, std::size_t line, long long count) const {
    fail(line, fmt::format("the index {} selects no vertex", index),
         count == 0 ? "there are no vertices to select"
                    : fmt::format("1 to {}, or -1 to -{} counted back from the last, is allowed", count, count));
  }

  static std::string in_quotes(std::string_view word) { return '"' + excerpt(word) + '"'; }

  void check_line(std::string_view line) {
    const std::string_view keyword = next_word(line);
    if (keyword.empty()) return;
    if (keyword == "v") {
      check_vertex(line);
    } else if (keyword == "f") {
      check_face(line);
    } else {
      unread_.count(keyword);
    }
  }

  void check_vertex(std::string_view line) {
    outline_.plain += 'v';
    glm::dvec3 vertex;
    for (int i = 0; i < 3; ++i) {
      const std::string_view word = next_word(line);
      if (word.empty()) fail(line_, fmt::format("a vertex with {} coordinates", i), "three are needed");
      if (!parse_whole(word, vertex[i]) || !(std::abs(vertex[i]) <= max_coordinate)) {
        fail(line_, in_quotes(word) + " is no coordinate",
             fmt::format("a number from {} to {} is allowed", -max_coordinate, max_coordinate));
      }
      outline_.plain.append(" ").append(word);
    }
    outline_.plain += '\n';
    outline_.vertices.push_back(vertex);
    std::size_t more = 0;
    while (!next_word(line).empty()) ++more;
    if (more >= 3) unread_.count_vertex_color();
  }

  void check_face(std::string_view line) {
    std::uint32_t corners = 0;
    outline_.plain += 'f';
    for (std::string_view word = next_word(line); !word.empty(); word = next_word(line)) {
      check_corner(word);
      outline_.plain.append(" ").append(word.substr(0, word.find('/')));
      ++corners;
    }
    if (corners < 3) fail(line_, fmt::format("a face with {} corners", corners), "at least 3 are needed");
    outline_.plain += '\n';
    outline_.faces.push_back({line_, corners});
  }

  /// A corner is V, V/T, V//N or V/T/N: indices of a vertex, a texture coordinate and a normal; the slashes of absent
  /// ones may be there.
  void check_corner(std::string_view corner) {
    std::string_view rest = corner;
    for (int part = 0; part < 3; ++part) {
      const std::string_view word = rest.substr(0, rest.find('/'));
      const bool last = word.size() == rest.size();
      const bool may_be_empty = part > 0;
      int index = 0;
      if (!(word.empty() && may_be_empty) && !parse_whole(word, index)) break;
      if (part == 0) check_index(index);
      if (part > 0 && !word.empty() && index == 0) break;
      if (last) return;
      rest.remove_prefix(word.size() + 1);
    }
    fail(line_, in_quotes(corner) + " is no corner of a face",
         "V, V/T, V//N or V/T/N with indices other than 0 is allowed");
  }

  void check_index(long long index) {
    const auto count = static_cast<long long>(outline_.vertices.size());
    if (index == 0 || index < -count) fail_index(index, line_, count);
    if (index > largest_index_) {
      largest_index_ = index;
      largest_index_line_ = line_;
    }
  }

  const std::string& file_;
  ObjOutline outline_;
  ObjUnread unread_;
  std::size_t line_ = 0;
  long long largest_index_ = 0;
  std::size_t largest_index_line_ = 0;
};

}  // namespace

ObjOutline check_obj(std::string_view text, const std::string& file) { return ObjChecker(file).check(text); }

}  // namespace pyrasim
