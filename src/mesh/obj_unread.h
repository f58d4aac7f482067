// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace pyrasim {

/// Counts what of an OBJ file has no effect, so that its user is told.
class ObjUnread {
 public:
  /// A line with the keyword, which is none of those that are read.
  void count(std::string_view keyword);
  /// A vertex with a colour.
  void count_vertex_color() { ++vertex_colors_; }

  /// At most one for how things look, one for what is no face, and one for unknown keywords.
  std::vector<std::string> warnings() const;

 private:
  std::map<std::string, std::size_t, std::less<>> lines_;  ///< by keyword
  std::size_t vertex_colors_ = 0;
};

}  // namespace pyrasim
