// SPDX-License-Identifier: Apache-2.0
#include "hw_model/record/ray_columns.h"

#include <fmt/format.h>

namespace pyrasim::hw {

RayColumns::RayColumns(const SceneContents& contents)
    : lights_(contents.lights_with_shadows), names_{"row", "column", "object"} {
  for (std::size_t kind = 0; kind < surface_kinds; ++kind) {
    if (contents.surfaces[kind] > 0) kinds_.push_back(kind);
  }
  const auto add_tests = [&](const std::string& of) {
    names_.push_back(of + "box_tests");
    for (const std::size_t kind : kinds_) {
      names_.push_back(fmt::format("{}surface_tests.{}", of, surface_traits[kind].name));
    }
  };
  if (lights_ > 0) names_.emplace_back("lights");
  add_tests("");
  if (lights_ == 0) return;
  for (std::size_t light = 0; light < lights_; ++light) names_.push_back(fmt::format("shadow.rays.{}", light));
  add_tests("shadow.");
}

template <class AnyWork, class Visit>
void RayColumns::for_each_count(AnyWork& work, const Visit& visit) const {
  const auto visit_tests = [&](auto& tests) {
    visit(tests.box_tests);
    for (const std::size_t kind : kinds_) visit(tests.surface_tests[kind]);
  };
  visit_tests(work);
  if (lights_ == 0) return;
  for (std::size_t light = 0; light < lights_; ++light) visit(work.shadow.rays[light]);
  visit_tests(work.shadow.tests);
}

void RayColumns::write(std::uint32_t* row, GridPoint point, const Seen& seen, const Work& work) const {
  *row++ = point.row;
  *row++ = point.column;
  *row++ = seen.object + 1;  // no_object becomes 0
  if (lights_ > 0) *row++ = seen.lights;
  for_each_count(work, [&](std::uint64_t count) { *row++ = static_cast<std::uint32_t>(count); });
}

Seen RayColumns::read(const std::uint32_t* row, Work& work) const {
  row += 2;
  Seen seen;
  seen.object = *row++ - 1;
  if (lights_ > 0) seen.lights = *row++;
  for_each_count(work, [&](std::uint64_t& count) { count += *row++; });
  return seen;
}

void NodeColumns::write(std::uint32_t* row, const Cell& cell, const TextureWork& work) {
  row[0] = cell.corner.row;
  row[1] = cell.corner.column;
  row[2] = cell.log2_side;
  row[3] = static_cast<std::uint32_t>(work.places);
  row[4] = static_cast<std::uint32_t>(work.lines);
  row[5] = static_cast<std::uint32_t>(work.texels);
}

}  // namespace pyrasim::hw
