// SPDX-License-Identifier: Apache-2.0
#include "cli/frame_table.h"

#include <fmt/format.h>

#include "text/counted.h"
#include "text/printable.h"

namespace pyrasim::cli {
namespace {

std::string ray_lines(const FrameStatistics& frame) {
  std::string text = fmt::format("rays          {:>12}   primary {} + subdivision {}\n", grouped(frame.total_rays()),
                                 grouped(frame.primary_rays()), grouped(frame.subdivision_rays_traced()));
  const ShadowWork& shadow = frame.work.shadow;
  if (frame.lights_with_shadows == 0) return text;
  text += fmt::format("shadow rays   {:>12}   to {}\n", grouped(shadow.total_rays()),
                      counted(frame.lights_with_shadows, "light"));
  return text;
}

}  // namespace

std::string grouped(std::uint64_t number) {
  std::string text = std::to_string(number);
  for (auto k = static_cast<std::ptrdiff_t>(text.size()) - 3; k > 0; k -= 3)
    text.insert(static_cast<std::size_t>(k), 1, ',');
  return text;
}

std::string frame_title(const std::string& scene, const Screen& screen, const std::optional<PixelWindow>& window) {
  std::string title = fmt::format("{} at {}x{} pixels", one_line(scene), screen.columns, screen.rows);
  if (!window) return title;
  const auto& [column, row, columns, rows] = *window;
  return fmt::format("{}, {}x{} of them from column {}, row {}", title, columns, rows, column, row);
}

std::string frame_lines(const FrameStatistics& frame, int max_level) {
  std::string text = ray_lines(frame);
  text += fmt::format("subdivisions  {:>12}   terminal nodes {}\n\n", grouped(frame.subdivisions),
                      grouped(frame.terminal_nodes));
  text += fmt::format("level  {:>12}  {:>12}  {:>12}  {:>12}\n", "rays", "empty", "covered", "edge");
  for (std::size_t level = 0; level <= static_cast<std::size_t>(max_level); ++level) {
    const auto& cases = frame.cases_by_level[level];
    text += fmt::format("{:>5}  {:>12}  {:>12}  {:>12}  {:>12}\n", level, grouped(frame.rays_by_level[level]),
                        grouped(cases[0]), grouped(cases[1]), grouped(cases[2]));
  }
  return text;
}

std::string rendering_table(const std::string& scene, const Camera& camera, const Method& method,
                            const FrameStatistics& frame) {
  const std::string title = frame_title(scene, camera.screen, camera.window);
  if (!method.pyramid) return fmt::format("{}, {}\n\n{}", title, method.name(), ray_lines(frame));
  return fmt::format("{}, MAX_LEVEL {}\n\n{}", title, method.pyramids.max_level,
                     frame_lines(frame, method.pyramids.max_level));
}

}  // namespace pyrasim::cli
