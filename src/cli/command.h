// SPDX-License-Identifier: Apache-2.0
// What the commands share: options that several have, and where their output goes.
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cli/command_parser.h"
#include "image/image.h"
#include "image/png.h"
#include "render/method.h"
#include "scene/scene.h"

namespace pyrasim::cli {

/// Each adds its command to the program.
void add_render_command(const Command& program);
void add_simulate_command(const Command& program);
void add_sweep_command(const Command& program);
void add_whatif_command(const Command& program);
void add_view_command(const Command& program);
void add_study_command(const Command& program);
void add_budget_command(const Command& program);
void add_check_command(const Command& program);
void add_diagram_command(const Command& program);
void add_export_command(const Command& program);
void add_pixel_command(const Command& program);
void add_level_command(const Command& program);
void add_compare_command(const Command& program);
void add_formats_command(const Command& program);
/// These print what `parser` knows of the whole command line.
void add_completion_command(CommandParser& parser);
void add_man_command(CommandParser& parser);

/// The whole command line, as a shell would take it; every result names it.
const std::string& command_line();
void set_command_line(int argc, char** argv);

/// Options of a command that renders one frame of a scene.
struct FrameOptions {
  std::string scene;
  std::string size;                   ///< "COLUMNSxROWS", or empty: as the scene says
  std::optional<std::string> window;  ///< "X,Y,COLUMNS,ROWS" of the screen
  std::string max_level = "3";        ///< a number or "auto"
  EdgePolicy edge = EdgePolicy::mean;
  TextureFilter texture = TextureFilter::integral;
  std::string scalar = "double";

  /// Reads the scene, on the screen and window asked for; its warnings go to stderr.
  Scene load() const;
  /// The number formats asked for, which can address `screen` at `steps` grid steps along a pixel's side; a warning
  /// goes to stderr.
  DatapathFormats formats(const Screen& screen, std::int64_t steps) const;
};

/// Adds SCENE and --size.
void add_scene_options(const Command& command, FrameOptions& options);
/// Adds SCENE, --size, --max-level and --edge. --scalar and --window are the caller's choice.
void add_frame_options(const Command& command, FrameOptions& options);
void add_scalar_option(const Command& command, std::string& scalar);
void add_window_option(const Command& command, FrameOptions& options);
void add_max_level_option(const Command& command, std::string& max_level);
void add_edge_option(const Command& command, EdgePolicy& edge);
void add_texture_option(const Command& command, TextureFilter& filter);

/// What the loader has to remark on a scene, on stderr, a line each.
void print_warnings(const Scene& scene);

/// "640x480", the value of `option`. Throws UsageError.
std::pair<int, int> parse_size(const std::string& text, const std::string& option = "--size");
/// "X,Y,COLUMNS,ROWS" within `screen`. Throws UsageError.
PixelWindow parse_window(const std::string& text, const Screen& screen);
/// "ROW,COLUMN" of a pixel of `rendered`, counted on the screen. Throws UsageError, which `what` begins.
std::pair<int, int> parse_pixel(const std::string& text, const PixelWindow& rendered, const std::string& what);
/// A whole number from `least` to `most`; `what` names it in the UsageError.
int parse_number(const std::string& text, int least, int most, const std::string& what);
/// A level from 0 to max_level_limit, or what the criterion asks of `screen` for "auto".
int parse_max_level(const std::string& text, const Screen& screen);
/// `text` split at `separator`.
std::vector<std::string> split(const std::string& text, char separator);

/// -o and the picture's format.
struct ImageOutput {
  std::string file;
  PngFormat format;

  void add(const Command& command);
};

/// A file named on the command line, "-" for stdout, opened before the work begins so that a mistake shows at once.
class TextOutput {
 public:
  explicit TextOutput(const std::string& file);
  TextOutput(TextOutput&&) noexcept;
  ~TextOutput();
  void write(const std::string& text);

 private:
  struct File;
  std::unique_ptr<File> file_;  ///< none: stdout
};

/// A picture's file, opened before the work begins; nothing where no file is asked for.
class PictureOutput {
 public:
  explicit PictureOutput(ImageOutput options);
  PictureOutput(PictureOutput&&) noexcept;
  ~PictureOutput();
  void write(const Image& image);

 private:
  struct File;
  ImageOutput options_;
  std::unique_ptr<File> file_;
};

/// A bar on stderr where that is a terminal, else a line every 10 s; it says to stop when the user interrupts (see
/// interrupt.h). `label`: what is going on.
Progress progress_bar(const std::string& label);

}  // namespace pyrasim::cli
