// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <memory>

#include "cli/command.h"
#include "cli/output_plan.h"
#include "scene/pov_export.h"
#include "text/counted.h"
#include "version.h"

namespace pyrasim::cli {
namespace {

struct ExportCommand {
  FrameOptions frame;
  bool ids = false;
  std::string output;

  void run() const {
    const Scene scene = frame.load();
    OutputPlan plan;
    plan.reads("SCENE", scene.files);
    plan.writes("-o", output, {".pov"});
    TextOutput file(output);
    const auto textured = std::count_if(scene.objects.begin(), scene.objects.end(),
                                        [](const Object& object) { return object.texture != nullptr; });
    if (textured > 0 && !ids) {
      std::cerr << fmt::format("pyrasim: warning: the textures of {} are written as their mean colours\n",
                               counted(static_cast<std::uint64_t>(textured), "object"));
    }
    file.write(pov_scene(scene, ids, fmt::format("pyrasim {}: {}", version(), command_line())));
  }
};

}  // namespace

void add_export_command(const Command& program) {
  auto options = std::make_shared<ExportCommand>();
  const Command command =
      program.add_command("export", "Write a scene in the language of POV-Ray 3.7.", [options] { options->run(); });
  command.add_text("-o,--output", options->output, "the scene in POV-Ray's language; - for stdout")
      .required()
      .type_name("FILE.pov|-");
  command.add_flag("--ids", options->ids, "a flat colour for each object, without light, on black");
  add_scene_options(command, options->frame);
}

}  // namespace pyrasim::cli
