// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <iostream>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/command.h"
#include "cli/frame_table.h"
#include "cli/map_outputs.h"
#include "cli/output_plan.h"
#include "cli/statistics_document.h"
#include "error.h"
#include "run/interrupt.h"

namespace pyrasim::cli {
namespace {

struct RenderCommand {
  static constexpr std::size_t map_kinds = 2;  // without a machine no latency

  FrameOptions frame;
  ImageOutput image;
  std::string method = "pyramid";
  Reuse reuse = Reuse::none;
  std::uint64_t seed = 1;
  int threads = 0;
  std::string stats;
  std::vector<std::string> maps;

  void run() const {
    const Scene scene = frame.load();
    Method chosen = parse_method(method);
    chosen.pyramids = {.max_level = parse_max_level(frame.max_level, scene.camera.screen),
                       .edge = frame.edge,
                       .reuse = reuse,
                       .threads = threads,
                       .texture = frame.texture};
    chosen.sampling.seed = seed;
    const DatapathFormats formats = frame.formats(scene.camera.screen, chosen.grid_steps());
    OutputPlan plan;
    plan.reads("SCENE", scene.files);
    plan.writes("-o", image.file);
    plan.writes_usually("--stats", stats, ".json");
    MapOutputs pictures_of_cost(maps, map_kinds, plan);
    if (!maps.empty() && !chosen.pyramid) {
      throw UsageError(fmt::format("--map: maps are of pixel pyramids, and --method {} has none", chosen.name()));
    }
    PictureOutput picture(image);
    pictures_of_cost.open();
    std::optional<TextOutput> statistics;
    if (!stats.empty()) statistics.emplace(stats);
    chosen.pyramids.maps = pictures_of_cost.begin(scene.camera.rendered(), chosen.pyramids.max_level);
    Rendering rendering;
    double done = 0;
    const Progress progress = [&done, bar = progress_bar("rendering")](double share) {
      done = share;
      return bar(share);
    };
    run_interruptibly([&] { rendering = render(scene, chosen, formats, threads, progress); },
                      [&] { return fmt::format("with {:.1f} % rendered", 100 * done); });
    picture.write(rendering.image);
    if (statistics) statistics->write(text_of(render_document(frame.scene, scene.camera, chosen, formats, rendering)));
    if (!plan.writes_anything())
      plan.table() << rendering_table(frame.scene, scene.camera, chosen, rendering.statistics);
    pictures_of_cost.write(plan.table());
  }
};

}  // namespace

void add_render_command(const Command& program) {
  auto options = std::make_shared<RenderCommand>();
  const Command command = program.add_command(
      "render", "Render a frame without timing, by pyramids or by a peer; without -o and --stats, print its counts.",
      [options] { options->run(); });
  add_frame_options(command, options->frame);
  add_texture_option(command, options->frame.texture);
  add_window_option(command, options->frame);
  add_scalar_option(command, options->frame.scalar);
  options->image.add(command);
  command.add_text("--method", options->method, "pyramids, or a peer: N x N rays a pixel, regular or jittered")
      .type_name("pyramid|point|grid:N|jitter:N")
      .show_default();
  command.add_choice<Reuse>("--reuse", options->reuse,
                            {{"none", Reuse::none}, {"pixel", Reuse::pixel}, {"frame", Reuse::frame}},
                            "which points are traced once only: none, a pixel's, the frame's");
  command.add_integer("--seed", options->seed, 0, std::numeric_limits<std::uint64_t>::max(), "of jitter:N")
      .show_default();
  command.add_integer("--threads", options->threads, 0, 1024, "0: one for each core; results do not depend on it")
      .show_default();
  command.add_text("--stats", options->stats, "statistics as JSON; - for stdout").type_name("FILE|-");
  add_map_option(command, options->maps, RenderCommand::map_kinds);
}

}  // namespace pyrasim::cli
