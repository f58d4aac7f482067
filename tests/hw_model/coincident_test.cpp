// SPDX-License-Identifier: Apache-2.0
// Surfaces in the same place: the first in the scene is seen, however many units share the rays.
#include <gtest/gtest.h>

#include "../test_scenes.h"
#include "simulation.h"

namespace pyrasim::hw {
namespace {

/// Each sphere and triangle three times over, every copy of its own color.
Scene scene_of_copies() {
  Scene scene = random_scene(61, {8, 8, 1}, 16, 12);
  std::vector<Object> once;
  once.swap(scene.objects);
  for (int copy = 0; copy < 3; ++copy) {
    for (Object entry : once) {
      entry.color = copy == 0 ? entry.color : glm::dvec3(copy, 0, 0);
      scene.objects.push_back(entry);
    }
  }
  return scene;
}

TEST(CoincidentSurfaces, DoNotDependOnTheNumberOfUnits) {
  const Scene copies = scene_of_copies();
  Scene once = copies;
  once.objects.resize(copies.objects.size() / 3);
  Simulation simulation;
  std::vector<std::pair<Processor*, Rendering>> runs;
  for (const char* format : {"double", "fp16", "fix32.16"}) {
    SimulationOptions options;
    options.max_level = 2;
    options.formats = parse_datapath_formats(format);
    const Image expected = reference(once, options).image;
    for (const std::size_t units : {1, 2, 5, 16}) {
      for (const Dispatch dispatch : {Dispatch::round_robin, Dispatch::first_free}) {
        MachineSpec spec;
        spec.intersection_units = units;
        spec.dispatch = dispatch;
        runs.emplace_back(&simulation.add(copies, spec, options), reference(copies, options));
        EXPECT_TRUE(runs.back().second.image.pixels() == expected.pixels()) << format;
      }
    }
  }
  simulation.run();
  for (const auto& [machine, expected] : runs) expect_results(*machine, expected);
}

}  // namespace
}  // namespace pyrasim::hw
