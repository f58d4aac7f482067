// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <iostream>
#include <memory>

#include "cli/command.h"
#include "cli/compare_runs.h"
#include "cli/output_plan.h"
#include "cli/statistics_document.h"
#include "error.h"
#include "image/compare_view.h"
#include "image/image_error.h"
#include "image/write_image.h"
#include "text/counted.h"
#include "text/printable.h"

namespace pyrasim::cli {
namespace {

bool is_run(const std::string& file) { return std::filesystem::path(file).extension() == ".json"; }

/// A picture to compare; that transparent pixels are not shown as they are is said in `remarks`.
Image read_picture(const std::string& file, std::string& remarks) {
  std::uint64_t transparent = 0;
  Image image = read_image(file, &transparent);
  if (transparent > 0) {
    remarks += fmt::format("{}: {} {} not opaque; composed over black\n", one_line(file), counted(transparent, "pixel"),
                           of_number(transparent, "is", "are"));
  }
  return image;
}

struct CompareCommand {
  std::string first;
  std::string second;
  ImageOutput image;
  std::string crop = "80x60";
  std::string at;
  int scale = 6;
  std::string stats;
  std::optional<Command> command;  ///< set where it is added

  void run() const {
    OutputPlan plan;
    plan.reads("FIRST", first);
    plan.reads("SECOND", second);
    plan.writes("-o", image.file);
    plan.writes_usually("--stats", stats, ".json");
    if (!is_run(first) && !is_run(second)) return compare_pictures(plan.table());
    if (!is_run(first) || !is_run(second)) {
      throw UsageError(fmt::format(
          "compare {} {}: two pictures (.png, .pfm) or the statistics of two runs (.json) are allowed", first, second));
    }
    for (const char* option : {"-o", "--png-bits", "--png-encoding", "--crop", "--at", "--scale"}) {
      if (command->given(option)) throw UsageError(fmt::format("{}: allowed where pictures are compared", option));
    }
    compare_runs(plan.table());
  }

  void compare_runs(std::ostream& table) const {
    std::optional<TextOutput> statistics;
    if (!stats.empty()) statistics.emplace(stats);
    const RunFile a(first);
    const RunFile b(second);
    if (statistics) statistics->write(text_of(comparison_document(a, b)));
    table << comparison_table(a, b);
  }

  void compare_pictures(std::ostream& table) const {
    const auto [columns, rows] = parse_size(crop, "--crop");
    PictureOutput picture(image);
    std::optional<TextOutput> statistics;
    if (!stats.empty()) statistics.emplace(stats);
    std::string remarks;
    const Image a = read_picture(first, remarks);
    const Image b = read_picture(second, remarks);
    const ImageError error = image_error(a, b);
    const double decibels = psnr(a, b);
    Crop part = busiest_crop(a, b, rows, columns);
    if (!at.empty()) {
      const std::vector<std::string> corner = split(at, ',');
      if (corner.size() != 2) throw UsageError("--at " + excerpt(at) + ": COLUMN,ROW is allowed, as in 300,120");
      part.column = parse_number(corner[0], 0, a.columns() - part.columns, "--at: column");
      part.row = parse_number(corner[1], 0, a.rows() - part.rows, "--at: row");
    }
    picture.write(side_by_side(a, b, part.row, part.column, part.rows, part.columns, scale));
    if (statistics) statistics->write(text_of(document(error, decibels)));
    table << remarks
          << fmt::format("RMSE {:.6g}, maximum {:.6g}, PSNR {:.2f} dB\n", error.rmse, error.maximum, decibels);
  }

  /// JSON has no infinity: null.
  nlohmann::ordered_json document(const ImageError& error, double decibels) const {
    return {{"command", command_line()}, {"first", first},           {"second", second},
            {"rmse", error.rmse},        {"maximum", error.maximum}, {"psnr_db", decibels}};
  }
};

}  // namespace

void add_compare_command(const Command& program) {
  auto options = std::make_shared<CompareCommand>();
  const Command command = program.add_command(
      "compare",
      "Errors between two pictures, and both enlarged where they differ most; or what differs between two runs.",
      [options] { options->run(); });
  options->command = command;
  command.add_text("FIRST", options->first, "picture (.png or .pfm; composed over black), or a run's --stats (.json)")
      .required();
  command.add_text("SECOND", options->second, "picture of the same size, or another run's").required();
  options->image.add(command);
  command.add_text("--crop", options->crop, "size of the enlarged part").type_name("COLUMNSxROWS").show_default();
  command.add_text("--at", options->at, "its upper left pixel; where the pictures differ most without it")
      .type_name("COLUMN,ROW");
  command.add_integer("--scale", options->scale, 1, 64, "enlargement").show_default();
  command.add_text("--stats", options->stats, "the result as JSON; - for stdout").type_name("FILE|-");
}

}  // namespace pyrasim::cli
