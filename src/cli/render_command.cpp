// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "cli/choice.h"
#include "cli/command.h"
#include "cli/interrupt.h"
#include "cli/statistics_document.h"

namespace pyrasim::cli {
namespace {

struct RenderCommand {
  FrameOptions frame;
  ImageOutput image;
  std::string method = "pyramid";
  Reuse reuse = Reuse::none;
  std::uint64_t seed = 1;
  int threads = 0;
  std::string stats;

  void run() const {
    const Scene scene = frame.load();
    Method chosen = parse_method(method);
    chosen.pyramids = {parse_max_level(frame.max_level, scene.camera.screen), frame.leaf, reuse, threads};
    chosen.sampling.seed = seed;
    const DatapathFormats formats = frame.formats(
        scene.camera.screen, chosen.pyramid ? std::int64_t{1} << chosen.pyramids.max_level : chosen.sampling.grid);
    PictureOutput picture(image);
    std::optional<TextOutput> statistics;
    if (!stats.empty()) statistics.emplace(stats);
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
  }
};

}  // namespace

void add_render_command(CLI::App& app, Action& action) {
  auto options = std::make_shared<RenderCommand>();
  CLI::App* command = app.add_subcommand("render", "Render a frame without timing, by pyramids or by a peer.");
  add_frame_options(*command, options->frame);
  add_window_option(*command, options->frame);
  add_scalar_option(*command, options->frame.scalar);
  options->image.add(*command);
  command->add_option("--method", options->method, "pyramids, or a peer: N x N rays a pixel, regular or jittered")
      ->type_name("pyramid|point|grid:N|jitter:N")
      ->capture_default_str();
  add_choice(*command, "--reuse", options->reuse,
             {{"none", Reuse::none}, {"pixel", Reuse::pixel}, {"frame", Reuse::frame}},
             "which points are traced once only: none, a pixel's, the frame's");
  command->add_option("--seed", options->seed, "of jitter:N")->capture_default_str();
  command->add_option("--threads", options->threads, "0: one for each core; results do not depend on it")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
  command->add_option("--stats", options->stats, "statistics as JSON; - for stdout")->type_name("FILE|-");
  command->callback([&action, options] { action = [options] { options->run(); }; });
}

}  // namespace pyrasim::cli
