// SPDX-License-Identifier: Apache-2.0
#include "cli/asked_run.h"

#include "render/picture_memory.h"

namespace pyrasim::cli {

SceneFiles files_of(const std::string& name, const Scene& scene) { return {name, sha256_of_files(scene.files)}; }

AskedRun asked_run(const FrameOptions& frame, const MachineOptions& machine) {
  auto scene = std::make_shared<const Scene>(frame.load());
  Run run;
  run.scene = files_of(frame.scene, *scene);
  run.screen = scene->camera.screen;
  run.window = scene->camera.window;
  run.machine = machine.load();
  run.max_cycles = machine.max_cycles;
  run.max_level = parse_max_level(frame.max_level, run.screen);
  run.edge = frame.edge;
  run.texture = frame.texture;
  check_addressable(run.screen, run.max_level);
  check_picture_fits(run.rendered());
  run.formats = frame.formats(run.screen, std::int64_t{1} << run.max_level);
  hw::check_machine_holds(run.machine, run.max_level, run.rendered().columns);
  return {std::move(run), std::move(scene)};
}

}  // namespace pyrasim::cli
