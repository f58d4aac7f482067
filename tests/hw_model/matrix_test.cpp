// SPDX-License-Identifier: Apache-2.0
// Every shipped scene on machines of several sizes and on both engines, against the reference renderer.
#include <gtest/gtest.h>

#include "../shipped_scene.h"
#include "image/image_hash.h"
#include "simulation.h"

namespace pyrasim::hw {
namespace {

struct Case {
  const char* scene;
  int columns, rows;
  int max_level;
};

void PrintTo(const Case& parameters, std::ostream* out) {
  *out << parameters.scene << " " << parameters.columns << "x" << parameters.rows << " MAX_LEVEL "
       << parameters.max_level;
}

class Matrix : public testing::TestWithParam<Case> {};

TEST_P(Matrix, EnginesAgreeAndResultsAreTheReferences) {
  const Case& parameters = GetParam();
  Scene scene = shipped_scene(parameters.scene);
  scene.camera.screen = resized(scene.camera.screen, parameters.columns, parameters.rows);
  Simulation simulation;
  std::vector<std::pair<Processor*, Processor*>> pairs;
  for (const std::size_t units : {1, 4}) {
    for (const std::size_t depth : {1, 2, 8}) {
      MachineSpec spec = with_all_fifos({}, depth);
      spec.intersection_units = units;
      SimulationOptions options;
      options.max_level = parameters.max_level;
      Processor& decoupled = simulation.add(scene, spec, options);
      options.engine = Engine::lockstep;
      pairs.emplace_back(&decoupled, &simulation.add(scene, spec, options));
    }
  }
  simulation.run();
  const Rendering expected = reference(scene, parameters.max_level);
  const std::string hash = image_sha256(expected.image);
  for (const auto& [decoupled, lockstep] : pairs) {
    for (const Processor* machine : {decoupled, lockstep}) {
      EXPECT_EQ(image_sha256(machine->image()), hash);
      expect_results(*machine, expected);
      expect_sound(*machine);
    }
    expect_same_time(*decoupled, *lockstep);
  }
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const int max_level : {0, 1, 3, 5}) {
    for (const char* scene : {"keel", "spheres", "fins"}) all.push_back({scene, 96, 72, max_level});
    all.push_back({"shadows", 48, 36, max_level});
    all.push_back({"bunny", 48, 36, max_level});
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(ShippedScenes, Matrix, testing::ValuesIn(cases()), [](const auto& test) {
  return std::string(test.param.scene) + "_level_" + std::to_string(test.param.max_level);
});

}  // namespace
}  // namespace pyrasim::hw
