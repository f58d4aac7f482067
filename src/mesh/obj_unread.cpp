// SPDX-License-Identifier: Apache-2.0
#include "mesh/obj_unread.h"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>

#include "text/counted_names.h"

namespace pyrasim {
namespace {

constexpr std::string_view silent[] = {"s"};  ///< normals say what is smooth

// Wavefront, Object Files (.obj), version 3.0: grouping and display attributes, elements, free-form geometry.
constexpr std::string_view looks[] = {"usemap",   "maplib",     "mg",        "bevel", "lod",  "c_interp",
                                      "d_interp", "shadow_obj", "trace_obj", "ctech", "stech"};
constexpr std::string_view other_shapes[] = {"l",     "p",    "vp",   "cstype", "deg",  "bmat", "step", "curv",
                                             "curv2", "surf", "parm", "trim",   "hole", "scrv", "sp",   "end",
                                             "con",   "bzp",  "bsp",  "cdc",    "cdp",  "res"};

template <std::size_t N>
bool is_one_of(const std::string_view (&names)[N], std::string_view name) {
  return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

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
        fmt::format("how things look is not read ({}); materials (usemtl) are, of one colour each or a picture",
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
