// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <iostream>
#include <memory>

#include "cli/command.h"
#include "error.h"
#include "pyramid/max_level.h"
#include "scene/load_scene.h"

namespace pyrasim::cli {
namespace {

struct LevelCommand {
  std::string scene;
  double pixel_size = 0;
  double distance = 0;
  double eye = eye_resolution;

  void run() const {
    const double angle = measured_angle();
    const int needed = required_max_level(angle, eye);
    std::cout << fmt::format("a pixel spans   {:.4g} rad = 2^{:.2f}\n", angle, std::log2(angle))
              << fmt::format("the eye tells   {:.4g} rad = 2^{:.2f}\n", eye, std::log2(eye))
              << fmt::format("log2 of ratio   {:.2f}\n\nlevel  subpixel, rad  staircase\n", std::log2(angle / eye));
    for (int level = 0; level <= needed; ++level) {
      std::cout << fmt::format("{:>5}  {:>13.4g}  {}\n", level, std::ldexp(angle, -level),
                               level < needed ? "visible" : "too fine to be seen");
    }
    std::cout << fmt::format("\nMAX_LEVEL = {}{}\n", needed,
                             needed > max_level_limit ? fmt::format(", above the limit of {}", max_level_limit) : "");
  }

  double measured_angle() const {
    if (!scene.empty()) {
      if (pixel_size != 0 || distance != 0) throw UsageError("level: either SCENE, or --pixel-size and --distance");
      return pixel_angle(load_scene(scene).camera.screen);
    }
    if ((pixel_size == 0) != (distance == 0)) throw UsageError("level: --pixel-size and --distance go together");
    return pixel_size == 0 ? std::ldexp(1.0, -10) : pixel_angle(pixel_size, distance);
  }
};

}  // namespace

void add_level_command(const Command& program) {
  auto options = std::make_shared<LevelCommand>();
  const Command command = program.add_command(
      "level",
      "The MAX_LEVEL criterion step by step: from a scene's screen, from a pixel's size and the viewing "
      "distance, or else for the article's display of 2^-10 rad a pixel.",
      [options] { options->run(); });
  command.add_text("SCENE", options->scene, "scene file: its pixels seen from its centre of projection");
  command.add_number("--pixel-size", options->pixel_size, 1e-30, 1e30, "side of a pixel, in any unit of length");
  command.add_number("--distance", options->distance, 1e-30, 1e30, "from the eye to the screen, in the same unit");
  command.add_number("--eye", options->eye, 1e-12, 1, "angle that the eye resolves, rad").show_default("2^-13");
}

}  // namespace pyrasim::cli
