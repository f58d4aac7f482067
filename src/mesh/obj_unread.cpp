// SPDX-License-Identifier: Apache-2.0
#include "mesh/obj_unread.h"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>

#include "text/printable.h"

namespace pyrasim {
namespace {

constexpr std::size_t most_names = 8;                     ///< that a warning lists
constexpr std::size_t longest_name = 20;                  ///< characters
constexpr std::string_view silent[] = {"s", "vn", "vt"};  ///< for smooth shading and textures, which do not exist

// Wavefront, Object Files (.obj), version 3.0: grouping and display attributes, elements, free-form geometry.
constexpr std::string_view looks[] = {"usemtl",   "mtllib",     "usemap",    "maplib", "o",
                                      "g",        "mg",         "bevel",     "lod",    "c_interp",
                                      "d_interp", "shadow_obj", "trace_obj", "ctech",  "stech"};
constexpr std::string_view other_shapes[] = {"l",     "p",    "vp",   "cstype", "deg",  "bmat", "step", "curv",
                                             "curv2", "surf", "parm", "trim",   "hole", "scrv", "sp",   "end",
                                             "con",   "bzp",  "bsp",  "cdc",    "cdp",  "res"};

template <std::size_t N>
bool is_one_of(const std::string_view (&names)[N], std::string_view name) {
  return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

/// "g 2, o 1": a list of what was counted, not longer than a line.
class CountedNames {
 public:
  void add(std::string_view name, std::size_t count) {
    if (count == 0) return;
    if (++names_ > most_names) return;
    text_ += fmt::format("{}{} {}", text_.empty() ? "" : ", ", excerpt(name, longest_name), count);
  }

  bool empty() const { return names_ == 0; }

  std::string text() const {
    return names_ > most_names ? fmt::format("{} and {} more", text_, names_ - most_names) : text_;
  }

 private:
  std::string text_;
  std::size_t names_ = 0;
};

}  // namespace

void ObjUnread::count(std::string_view keyword) {
  if (is_one_of(silent, keyword)) return;
  const auto found = lines_.find(keyword);
  if (found == lines_.end()) {
    lines_.emplace(keyword, 1);
  } else {
    ++found->second;
  }
}

std::vector<std::string> ObjUnread::warnings() const {
  CountedNames looks_found;
  CountedNames shapes_found;
  CountedNames unknown;
  for (const auto& [keyword, count] : lines_) {
    (is_one_of(looks, keyword)          ? looks_found
     : is_one_of(other_shapes, keyword) ? shapes_found
                                        : unknown)
        .add(keyword, count);
  }
  looks_found.add("colours of vertices", vertex_colors_);
  std::vector<std::string> result;
  if (!looks_found.empty()) {
    result.push_back(
        fmt::format("materials and groups are not read ({}); the colour is the object's in the scene, and all groups "
                    "are one object",
                    looks_found.text()));
  }
  if (!shapes_found.empty()) {
    result.push_back(
        fmt::format("lines, points and free-form surfaces are not read ({}); faces (f) are", shapes_found.text()));
  }
  if (!unknown.empty()) {
    result.push_back(fmt::format("unknown keywords ({}); their lines are passed over", unknown.text()));
  }
  return result;
}

}  // namespace pyrasim
