// SPDX-License-Identifier: Apache-2.0
// Two machines side by side in one simulation of one's own: the same scene, one picture and one count of cycles each.
// Usage: two_machines SCENE.json FIRST.json SECOND.json     writes first.png and second.png
#include <array>
#include <iostream>
#include <memory>
#include <systemc>

#include "error.h"
#include "hw_model/machine_spec.h"
#include "hw_model/processor.h"
#include "hw_model/report/deadlock.h"
#include "image/write_image.h"
#include "scene/load_scene.h"

namespace {

using namespace pyrasim;

void simulate(const char* scene_file, const char* first, const char* second) {
  const Scene scene = load_scene(scene_file);
  const std::array<hw::MachineSpec, 2> specs{hw::load_machine(first), hw::load_machine(second)};
  const std::array<const char*, 2> names{"first", "second"};

  // Modules have to be there before the simulation begins, and to stay where they are.
  std::array<std::unique_ptr<hw::Processor>, 2> processors;
  for (std::size_t k = 0; k < 2; ++k) {
    processors[k] = std::make_unique<hw::Processor>(names[k], scene, specs[k], hw::SimulationOptions{});
  }
  sc_core::sc_start();

  for (std::size_t k = 0; k < 2; ++k) {
    hw::require_finished(*processors[k]);  // says what the machine waits for if it stands still
    std::cout << names[k] << ' ' << specs[k].name << ' ' << processors[k]->cycles() << " cycles\n";
    write_image(std::string(names[k]) + ".png", processors[k]->image());
  }
}

}  // namespace

int sc_main(int argc, char** argv) {
  if (argc != 4) {
    std::cerr << "usage: two_machines SCENE.json FIRST.json SECOND.json\n";
    return pyrasim::exit_usage;
  }
  try {
    simulate(argv[1], argv[2], argv[3]);
    return pyrasim::exit_ok;
  } catch (const pyrasim::Error& error) {
    std::cerr << "two_machines: " << error.what() << '\n';
    return error.exit_code();
  }
}
