// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <charconv>
#include <iostream>

#include "cli/command.h"
#include "error.h"
#include "pyramid/max_level.h"
#include "scene/load_scene.h"
#include "text/printable.h"

namespace pyrasim::cli {

Scene FrameOptions::load() const {
  Scene loaded = load_scene(scene);
  print_warnings(loaded);
  if (!size.empty()) {
    const auto [columns, rows] = parse_size(size);
    loaded.camera.screen = resized(loaded.camera.screen, columns, rows);
  }
  if (window) loaded.camera.window = parse_window(*window, loaded.camera.screen);
  return loaded;
}

DatapathFormats FrameOptions::formats(const Screen& screen, std::int64_t steps) const {
  const DatapathFormats parsed = parse_datapath_formats(scalar);
  if (const auto warning = check_addressing(parsed, screen, steps)) {
    std::cerr << "pyrasim: warning: " << *warning << '\n';
  }
  return parsed;
}

void add_scene_options(const Command& command, FrameOptions& options) {
  command.add_text("SCENE", options.scene, "scene file (JSON or NFF)").required();
  command.add_text("--size", options.size, "pixels of the screen; its width, distance and the pixel's aspect stay")
      .type_name("COLUMNSxROWS");
}

void add_frame_options(const Command& command, FrameOptions& options) {
  add_scene_options(command, options);
  add_max_level_option(command, options.max_level);
  add_edge_option(command, options.edge);
}

void add_max_level_option(const Command& command, std::string& max_level) {
  command.add_text("--max-level", max_level, "deepest level of subdivision, or auto: what the eye can tell")
      .type_name("L|auto")
      .show_default();
}

void add_edge_option(const Command& command, EdgePolicy& edge) {
  command.add_choice<EdgePolicy>("--edge", edge, {{"mean", EdgePolicy::mean}, {"drop", EdgePolicy::drop}},
                                 "an edge at the deepest level: mean of its corners, or drop (background)");
}

void add_texture_option(const Command& command, TextureFilter& filter) {
  command.add_choice<TextureFilter>("--texture", filter,
                                    {{"integral", TextureFilter::integral}, {"point", TextureFilter::point}},
                                    "what a pyramid takes of a texture: its mean over what it covers, or its corners'");
}

void add_scalar_option(const Command& command, std::string& scalar) {
  command
      .add_text("--scalar", scalar,
                "number format of the datapath, or of each stage: view_vectors=FORMAT,intersection=FORMAT; "
                "pyrasim formats says which there are")
      .type_name("FORMAT")
      .show_default();
}

void add_window_option(const Command& command, FrameOptions& options) {
  command
      .add_text("--window", options.window,
                "only this part of the screen: its left column and top row, from 0, and its size, in pixels")
      .type_name("X,Y,COLUMNS,ROWS");
}

void print_warnings(const Scene& scene) {
  for (const std::string& warning : scene.warnings) std::cerr << "pyrasim: warning: " << message_line(warning) << '\n';
}

int parse_number(const std::string& text, int least, int most, const std::string& what) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || number < least || number > most) {
    throw UsageError(
        fmt::format("{} {}: a whole number from {} to {} is allowed", what, value_excerpt(text), least, most));
  }
  return number;
}

std::pair<int, int> parse_size(const std::string& text, const std::string& option) {
  const std::size_t cross = text.find('x');
  if (cross == std::string::npos) {
    throw UsageError(fmt::format("{} {}: COLUMNSxROWS is allowed, as in 640x480", option, value_excerpt(text)));
  }
  return {parse_number(text.substr(0, cross), 1, max_screen_size, option + ": columns"),
          parse_number(text.substr(cross + 1), 1, max_screen_size, option + ": rows")};
}

PixelWindow parse_window(const std::string& text, const Screen& screen) {
  const std::vector<std::string> parts = split(text, ',');
  if (parts.size() != 4) {
    throw UsageError(fmt::format("--window {}: X,Y,COLUMNS,ROWS is allowed, as in 0,0,64,48", value_excerpt(text)));
  }
  const int column = parse_number(parts[0], 0, screen.columns - 1, "--window: x");
  const int row = parse_number(parts[1], 0, screen.rows - 1, "--window: y");
  return {column, row, parse_number(parts[2], 1, screen.columns - column, "--window: columns"),
          parse_number(parts[3], 1, screen.rows - row, "--window: rows")};
}

std::pair<int, int> parse_pixel(const std::string& text, const PixelWindow& rendered, const std::string& what) {
  const std::vector<std::string> parts = split(text, ',');
  if (parts.size() != 2) {
    throw UsageError(fmt::format("{} {}: ROW,COLUMN is allowed, as in 12,40", what, value_excerpt(text)));
  }
  return {parse_number(parts[0], rendered.row, rendered.row + rendered.rows - 1, what + ": row"),
          parse_number(parts[1], rendered.column, rendered.column + rendered.columns - 1, what + ": column")};
}

int parse_max_level(const std::string& text, const Screen& screen) {
  if (text == "auto") return std::min(required_max_level(pixel_angle(screen)), max_level_limit);
  return parse_number(text, 0, max_level_limit, "--max-level");
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (std::size_t end = text.find(separator); end != std::string::npos; end = text.find(separator, begin)) {
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  parts.push_back(text.substr(begin));
  return parts;
}

}  // namespace pyrasim::cli
