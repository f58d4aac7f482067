// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <iostream>
#include <memory>

#include "cli/command.h"
#include "error.h"
#include "image/compare_view.h"
#include "image/image_error.h"
#include "image/write_image.h"

namespace pyrasim::cli {
namespace {

struct CompareCommand {
  std::string first;
  std::string second;
  ImageOutput image;
  std::string crop = "80x60";
  std::string at;
  int scale = 6;

  void run() const {
    const auto [columns, rows] = parse_size(crop);
    PictureOutput picture(image);
    const Image a = read_image(first);
    const Image b = read_image(second);
    const ImageError error = image_error(a, b);
    Crop part = busiest_crop(a, b, rows, columns);
    if (!at.empty()) {
      const std::vector<std::string> corner = split(at, ',');
      if (corner.size() != 2) throw UsageError("--at " + at + ": COLUMN,ROW is allowed, as in 300,120");
      part.column = parse_number(corner[0], 0, a.columns() - part.columns, "--at: column");
      part.row = parse_number(corner[1], 0, a.rows() - part.rows, "--at: row");
    }
    picture.write(side_by_side(a, b, part.row, part.column, part.rows, part.columns, scale));
    std::cout << fmt::format("RMSE {:.6g}, maximum {:.6g}, PSNR {:.2f} dB\n", error.rmse, error.maximum, psnr(a, b));
  }
};

}  // namespace

void add_compare_command(const Command& program) {
  auto options = std::make_shared<CompareCommand>();
  const Command command =
      program.add_command("compare", "Errors between two pictures, and both enlarged where they differ most.",
                          [options] { options->run(); });
  command.add_text("FIRST", options->first, "picture (.png or .pfm)").required();
  command.add_text("SECOND", options->second, "picture of the same size").required();
  options->image.add(command);
  command.add_text("--crop", options->crop, "size of the enlarged part").type_name("COLUMNSxROWS").show_default();
  command.add_text("--at", options->at, "its upper left pixel; where the pictures differ most without it")
      .type_name("COLUMN,ROW");
  command.add_integer("--scale", options->scale, 1, 64, "enlargement").show_default();
}

}  // namespace pyrasim::cli
