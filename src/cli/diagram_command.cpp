// SPDX-License-Identifier: Apache-2.0
#include <iostream>
#include <memory>

#include "cli/command.h"
#include "cli/machine_options.h"
#include "hw_model/report/diagram.h"
#include "scene/load_scene.h"

namespace pyrasim::cli {
namespace {

struct DiagramCommand {
  std::string scene;
  std::string max_level = "3";
  MachineOptions machine;

  void run() const {
    const Scene loaded = load_scene(scene);
    print_warnings(loaded);
    hw::SimulationOptions options;
    options.max_level = parse_max_level(max_level, loaded.camera.screen);
    check_addressable(loaded.camera.screen, options.max_level);
    const hw::Processor processor("processor", loaded, machine.load(), options);
    std::cout << hw::block_diagram(processor);
  }
};

}  // namespace

void add_diagram_command(const Command& program) {
  auto options = std::make_shared<DiagramCommand>();
  const Command command = program.add_command(
      "diagram", "Print the block diagram of the machine that a scene's frame is simulated on, as Graphviz DOT.",
      [options] { options->run(); });
  command.add_text("SCENE", options->scene, "scene file (JSON or NFF)").required();
  add_max_level_option(command, options->max_level);
  options->machine.add(command);
}

}  // namespace pyrasim::cli
